// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Dirac_system.h
#include <Conformal_geometry_processing/mesh/Delaunay_view.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>

#include <gtest/gtest.h>

#include <limits>

#include "support/Counted_solver_traits.h"
#include "support/dirac_sources.h"
#include "support/meshes.h"
#include "support/thin_faces.h"

namespace cgp_test::dirac_system_response_tests {

/// The response of closed surfaces, of meshes and of their intrinsic Delaunay triangulations.

namespace CGP = Conformal_geometry_processing;

template <class Surface>
class Dirac_system_response : public testing::Test {
 protected:
  /// the surfaces of the operators, of meshes that are not Delaunay
  const std::vector<Surface> surfaces{Surface(perturbed(icosphere(2), .05)),
                                      Surface(perturbed(btorus(12), .04))};
};

using Surfaces = testing::Types<Mesh_view, CGP::Delaunay_view>;
TYPED_TEST_SUITE(Dirac_system_response, Surfaces);

TYPED_TEST(Dirac_system_response, inverts_the_matrix_on_vectors_without_sum)
{
  for (const TypeParam& surface : this->surfaces) {
    CGP::internal::Dirac_system system(surface);
    system.prepare_response();
    const Quaternion_matrix c = sources(surface.size_of_vertices(), 11);
    expect_solutions(surface, system.response(c), c);
  }
}

TYPED_TEST(Dirac_system_response, passes_over_what_has_no_solution)
{
  const TypeParam& surface = this->surfaces[1];
  CGP::internal::Dirac_system system(surface);
  system.prepare_response();
  const Quaternion_matrix c = sources(surface.size_of_vertices(), 1);
  Quaternion_matrix shifted = c;
  for (Eigen::Index i = 0; i < c.rows(); ++i) shifted(i, 0) += Quaternion<double>{1, -2, 3, 4};
  expect_solutions(surface, system.response(shifted), c);
}

TYPED_TEST(Dirac_system_response, to_nothing_is_nothing)
{
  const TypeParam& surface = this->surfaces[0];
  CGP::internal::Dirac_system system(surface);
  system.prepare_response();
  EXPECT_EQ(system.response(zero_matrix(surface.size_of_vertices(), 0)).cols(), 0);
  EXPECT_EQ(greatest_entry(system.response(zero_matrix(surface.size_of_vertices(), 2))), 0);
}

TEST(Dirac_system_response, responds_on_a_mesh_that_has_moved_with_the_same_analysis)
{
  Mesh_view mesh = btorus(12);
  CGP::internal::Dirac_system system(mesh, {}, "test", Counted_solver_traits());
  system.prepare_response();
  const int analyses = Counted_solver_traits::analyses();
  mesh.set_positions(perturbed(mesh, 0.04).positions());
  system.update_geometry();
  system.prepare_response();
  EXPECT_EQ(Counted_solver_traits::analyses(), analyses);
  const Quaternion_matrix c = sources(mesh.size_of_vertices(), 2);
  expect_solutions(mesh, system.response(c), c);
}

TEST(Dirac_system_response, responds_with_the_factor_for_any_rho)
{
  const Mesh_view mesh = btorus(12);
  const auto X = CGP::dirac_energy(mesh, CGP::no_potential(mesh));
  const Quaternion_matrix c = sources(mesh.size_of_vertices(), 3);
  for (const double amplitude : {0., 0.2}) {
    CGP::internal::Dirac_system system(mesh);
    CGP::internal::Dirac_solution::Seconds seconds;
    CGP::Curvature_potential rho = CGP::no_potential(mesh);
    rho.values = amplitude * random_numbers(mesh.size_of_vertices(), 5);
    system.set_potential(rho, seconds);
    int solves = 0;
    const auto y =
        CGP::internal::closed_response(X, system.areas(), system.solver(), c, 1e-11, solves);
    expect_solutions(mesh, y, c);
    EXPECT_GE(solves, 4);
    EXPECT_LE(solves, 40);
  }
}

TEST(Dirac_system_response, responds_on_faces_of_area_zero)
{
  const CGP::Delaunay_view surface(spoilt(icosphere(2)));
  CGP::internal::Dirac_system system(surface);
  system.prepare_response();
  const Quaternion_matrix c = sources(surface.size_of_vertices(), 2);
  expect_solutions(surface, system.response(c), c);
}

TEST(Dirac_system_response, refuses_to_respond_to_or_on_what_is_not_finite)
{
  Mesh_view mesh = btorus(8);
  CGP::internal::Dirac_system system(mesh);
  system.prepare_response();
  Quaternion_matrix c = sources(mesh.size_of_vertices(), 1);
  c(3, 0).y = std::numeric_limits<double>::infinity();
  EXPECT_THROW((void)system.response(c), CGP::Solver_error);
  Points p = mesh.positions();
  p(0, 0) = std::numeric_limits<double>::quiet_NaN();
  mesh.set_positions(p);
  system.update_geometry();
  EXPECT_THROW(system.prepare_response(), CGP::Solver_error);
}

}  // namespace cgp_test::dirac_system_response_tests
