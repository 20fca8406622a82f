// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/conformal_willmore_flow.h

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <functional>
#include <stdexcept>
#include <string>

#include "conformal_willmore_flow_checks.h"

namespace cgp_test::conformal_willmore_flow_surface_mesh_tests {

namespace params = CGP::parameters;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Surface = CGAL::Surface_mesh<Point>;
using Vertex = Surface::Vertex_index;

/// H itself: away from round
struct Outward {
  Eigen::VectorXd operator()(const Mesh_view& mesh) const { return CGP::mean_curvature(mesh); }
};

/// stops or throws after some steps
struct Visitor : CGP::Flow_visitor {
  int steps = 0, stop_after = 1000, throw_after = 1000;
  bool go_further() const { return steps < stop_after; }
  void on_step_end(const CGP::Flow_step_report&, const Mesh_view&)
  {
    if (++steps == throw_after) throw std::runtime_error("enough");
  }
};

class Conformal_willmore_flow_of_a_Surface_mesh : public testing::Test {
 protected:
  /// the positions of the class with these options
  Points expected(const CGP::Flow_options& options) const
  {
    CGP::Conformal_willmore_flow flow(before, options);
    (void)flow.run();
    return flow.mesh().positions();
  }
  template <class NamedParameters>
  Points flown(const NamedParameters& np)
  {
    (void)CGP::conformal_willmore_flow(mesh, np);
    return view_of(mesh).positions();
  }

  Surface mesh = to_cgal_mesh<Surface>(bumpy_sphere(2));
  const Mesh_view before = view_of(mesh);
};

std::string refusal(const Mesh_view& view)
{
  Surface mesh = to_cgal_mesh<Surface>(view);
  try {
    (void)CGP::conformal_willmore_flow(mesh);
  } catch (const CGP::Precondition_error& error) {
    EXPECT_EQ(error.function(), "conformal_willmore_flow");
    return error.message();
  }
  return "";
}

TEST_F(Conformal_willmore_flow_of_a_Surface_mesh, is_that_of_its_triangles)
{
  expect_flow(mesh, 1e-14);
}

TEST_F(Conformal_willmore_flow_of_a_Surface_mesh, takes_steps_as_told)
{
  CGP::Flow_options options;
  options.time_step = 0.5;
  options.max_steps = 2;
  EXPECT_EQ(flown(params::time_step(0.5).number_of_iterations(2)), expected(options));
}

TEST_F(Conformal_willmore_flow_of_a_Surface_mesh, stops_at_the_tolerance_it_is_given)
{
  CGP::Flow_options options;
  options.energy_tolerance = 0.1;
  EXPECT_EQ(flown(params::tolerance(0.1)), expected(options));
}

TEST_F(Conformal_willmore_flow_of_a_Surface_mesh, filters)
{
  CGP::Flow_options options;
  options.filter_weight = 0.01;
  options.filter_order = 2;
  options.max_steps = 2;
  EXPECT_EQ(flown(params::filter(CGP::Filter_options{0.01, 2}).number_of_iterations(2)),
            expected(options));
}

TEST_F(Conformal_willmore_flow_of_a_Surface_mesh, balances)
{
  CGP::Flow_options options;
  options.max_steps = 2;
  options.balance = CGP::Flow_options::Balance::initial;
  EXPECT_EQ(flown(params::balance(CGP::Flow_options::Balance::initial).number_of_iterations(2)),
            expected(options));
}

TEST_F(Conformal_willmore_flow_of_a_Surface_mesh, balances_towards_areas_in_a_map)
{
  CGP::Flow_options options;
  options.max_steps = 1;
  options.balance = CGP::Flow_options::Balance::prescribed;
  options.target_areas = CGP::vertex_areas(before).array() + 0.01;
  auto areas = mesh.add_property_map<Vertex, double>("v:target").first;
  for (const Vertex v : vertices(mesh)) areas[v] = options.target_areas[static_cast<int>(v)];
  EXPECT_EQ(flown(params::vertex_target_area_map(areas).number_of_iterations(1)),
            expected(options));
}

TEST_F(Conformal_willmore_flow_of_a_Surface_mesh, keeps_handles_closed_in_the_way_it_is_told)
{
  for (const CGP::Exactness exactness : {CGP::Exactness::adjoint, CGP::Exactness::thesis}) {
    CGP::Flow_options options;
    options.surface.exactness = exactness;
    options.max_steps = 1;
    Surface surface = to_cgal_mesh<Surface>(btorus(16));
    CGP::Conformal_willmore_flow flow(view_of(surface), options);
    (void)flow.run();
    EXPECT_TRUE(CGP::conformal_willmore_flow(surface,
                                             params::exactness(exactness).number_of_iterations(1)));
    EXPECT_EQ(view_of(surface).positions(), flow.mesh().positions());
  }
}

TEST_F(Conformal_willmore_flow_of_a_Surface_mesh, goes_other_ways)
{
  const double energy = CGP::willmore_energy(before);
  const CGP::Flow_report report =
      CGP::conformal_willmore_flow(mesh, params::curvature_direction(Outward())
                                             .time_step(0.1)
                                             .number_of_iterations(1)
                                             .random_seed(7)
                                             .sparse_solver(CGP::Default_solver_traits())
                                             .dirac(CGP::Dirac_options()));
  EXPECT_TRUE(report);
  EXPECT_GT(CGP::willmore_energy(view_of(mesh)), energy);
}

TEST_F(Conformal_willmore_flow_of_a_Surface_mesh, writes_points_to_a_map)
{
  auto output = mesh.add_property_map<Vertex, Point>("v:flown").first;
  EXPECT_TRUE(CGP::conformal_willmore_flow(mesh, params::output_vertex_point_map(output)));
  EXPECT_EQ(view_of(mesh).positions(), before.positions());
  const Points positions = expected({});
  for (const Vertex v : vertices(mesh)) {
    const auto p = positions.col(static_cast<int>(v));
    EXPECT_EQ(output[v], Point(p.x(), p.y(), p.z()));
  }
}

TEST_F(Conformal_willmore_flow_of_a_Surface_mesh, has_the_volume_that_is_wanted)
{
  CGP::Flow_options options;
  options.max_steps = 3;
  options.reduced_volume = .9;
  EXPECT_EQ(flown(params::number_of_iterations(3).reduced_volume(.9)), expected(options));
}

TEST_F(Conformal_willmore_flow_of_a_Surface_mesh,
       has_made_the_last_complete_step_when_it_is_stopped)
{
  Visitor visitor;
  visitor.stop_after = 1;
  const CGP::Flow_report report = CGP::conformal_willmore_flow(
      mesh, params::visitor(std::ref(visitor)).exact_conformal_class(false));
  EXPECT_EQ(report.stop, CGP::Flow_step_report::Stop::cancelled);
  CGP::Flow_options options;
  options.surface.exact_conformal_class = false;
  options.max_steps = 1;
  EXPECT_EQ(view_of(mesh).positions(), expected(options));
}

TEST_F(Conformal_willmore_flow_of_a_Surface_mesh, leaves_the_mesh_if_the_visitor_throws)
{
  Visitor visitor;
  visitor.throw_after = 2;
  EXPECT_THROW((void)CGP::conformal_willmore_flow(mesh, params::visitor(std::ref(visitor))),
               std::runtime_error);
  EXPECT_EQ(view_of(mesh).positions(), before.positions());
}

TEST_F(Conformal_willmore_flow_of_a_Surface_mesh, refuses_what_is_no_surface_and_no_step)
{
  EXPECT_NE(refusal(disjoint_union(icosphere(1), icosphere(1), {3, 0, 0})).find("2 components"),
            std::string::npos);
  EXPECT_THROW((void)CGP::conformal_willmore_flow(mesh, params::time_step(-1.)),
               CGP::Precondition_error);
  EXPECT_EQ(view_of(mesh).positions(), before.positions());
}

}  // namespace cgp_test::conformal_willmore_flow_surface_mesh_tests
