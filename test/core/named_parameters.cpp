// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/core/named_parameters.h
#include <Conformal_geometry_processing/core/named_parameters.h>
#include <Conformal_geometry_processing/harmonic_basis.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace cgp_test::named_parameters_tests {

namespace CGP = Conformal_geometry_processing;
namespace P = CGP::parameters;
namespace Tags = CGP::internal_np;

struct Answer {
  double time_step;
  int number_of_iterations;
  bool has_tolerance;
};

bool operator==(const Answer& a, const Answer& b)
{
  return a.time_step == b.time_step && a.number_of_iterations == b.number_of_iterations &&
         a.has_tolerance == b.has_tolerance;
}

/// asks for its parameters as the entry points do
template <typename CGAL_NP_TEMPLATE_PARAMETERS>
Answer ask(const CGAL_NP_CLASS& np = P::default_values())
{
  return {CGP::internal::parameter_or(np, Tags::time_step, .25),
          CGP::internal::parameter_or(np, CGAL::internal_np::number_of_iterations, 1),
          CGP::internal::has_parameter<CGAL_NP_CLASS, Tags::tolerance_t>};
}

template <class Pack>
bool is_only_time_step_and_iterations(const Pack&)
{
  return CGP::internal::only_known_parameters<Pack, Tags::time_step_t,
                                              CGAL::internal_np::number_of_iterations_t>;
}

/// cannot be copied, as a solver that holds a factorization
struct Stateful {
  Stateful() = default;
  Stateful(const Stateful&) = delete;
  int calls = 0;
};

TEST(Named_parameters, have_their_defaults_when_nothing_is_passed)
{
  EXPECT_EQ(ask(), (Answer{.25, 1, false}));
  EXPECT_EQ(ask(CGAL::parameters::default_values()), (Answer{.25, 1, false}));
}

TEST(Named_parameters, of_this_library_and_of_CGAL_chain_in_any_order)
{
  EXPECT_EQ(ask(P::time_step(.5)), (Answer{.5, 1, false}));
  EXPECT_EQ(ask(P::time_step(.5).number_of_iterations(7)), (Answer{.5, 7, false}));
  EXPECT_EQ(ask(P::number_of_iterations(7).tolerance(1e-8).time_step(.5)), (Answer{.5, 7, true}));
}

TEST(Named_parameters, accept_a_pack_made_by_CGAL)
{
  EXPECT_EQ(ask(CGAL::parameters::number_of_iterations(3)), (Answer{.25, 3, false}));
}

TEST(Named_parameters, join_a_pack_made_by_CGAL_from_either_side)
{
  const auto theirs = CGAL::parameters::number_of_iterations(9).random_seed(4);
  const auto ours = P::time_step(.125).tolerance(1e-3);
  EXPECT_EQ(ask(theirs | ours), (Answer{.125, 9, true}));
  EXPECT_EQ(ask(ours | theirs), (Answer{.125, 9, true}));
  EXPECT_EQ(ask(CGAL::parameters::default_values() | ours), (Answer{.125, 1, true}));
  EXPECT_EQ(ask((theirs | ours).time_step(.5)), (Answer{.5, 9, true}));
}

TEST(Named_parameters, take_the_value_on_the_right_when_joined_packs_disagree)
{
  EXPECT_EQ(ask(P::time_step(1.) | P::tolerance(1.).time_step(2.)), (Answer{2., 1, true}));
}

TEST(Named_parameters, pass_a_reference_to_what_has_a_state)
{
  Stateful visitor;
  const auto np = P::time_step(.5).visitor(std::ref(visitor));
  Stateful unused;
  Stateful& found = CGP::internal::parameter_or(np, CGAL::internal_np::visitor, unused);
  ++found.calls;
  EXPECT_EQ(visitor.calls, 1);
}

TEST(Named_parameters, refer_to_an_lvalue_fallback_and_return_an_rvalue_one)
{
  Stateful fallback;
  EXPECT_EQ(&CGP::internal::parameter_or(P::time_step(.5), CGAL::internal_np::visitor, fallback),
            &fallback);
  using Returned = decltype(CGP::internal::parameter_or(P::time_step(.5), Tags::tolerance, 1e-3));
  static_assert(std::is_same_v<Returned, double>);
}

TEST(Named_parameters, are_known_or_not)
{
  EXPECT_TRUE(is_only_time_step_and_iterations(P::default_values()));
  EXPECT_TRUE(is_only_time_step_and_iterations(P::time_step(1.).number_of_iterations(2)));
  EXPECT_TRUE(is_only_time_step_and_iterations(CGAL::parameters::number_of_iterations(2)));
  EXPECT_FALSE(is_only_time_step_and_iterations(P::tolerance(1.)));
  EXPECT_FALSE(is_only_time_step_and_iterations(P::tolerance(1.).time_step(1.)));
  EXPECT_FALSE(is_only_time_step_and_iterations(P::time_step(1.).tolerance(1.)));
  EXPECT_FALSE(is_only_time_step_and_iterations(CGAL::parameters::verbose(true)));
}

TEST(Named_parameters, of_ours_may_be_given_to_functions_of_CGAL)
{
  using Kernel = CGAL::Simple_cartesian<double>;
  CGAL::Surface_mesh<Kernel::Point_3> mesh;
  CGAL::make_tetrahedron(Kernel::Point_3(0, 0, 0), Kernel::Point_3(1, 0, 0),
                         Kernel::Point_3(0, 1, 0), Kernel::Point_3(0, 0, 1), mesh);
  const auto np = P::time_step(.5).vertex_point_map(mesh.points()).geom_traits(Kernel());
  EXPECT_NEAR(CGAL::Polygon_mesh_processing::area(mesh, np), 1.5 + std::sqrt(3.) / 2, 1e-15);
}

}  // namespace cgp_test::named_parameters_tests
