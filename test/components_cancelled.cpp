// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests spin_transform.h, conformal_willmore_flow.h
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <functional>

#include "components_checks.h"

namespace cgp_test::components_cancelled_tests {

namespace params = CGP::parameters;
using Surface = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

struct Visitor_that_cancels : CGP::Spin_visitor {
  int iterations = 0;
  void on_iteration(const CGP::Eigensolver_progress&) { ++iterations; }
  bool go_further() const { return false; }
};

/// says no once, after the first step
struct Visitor_that_cancels_once : CGP::Flow_visitor {
  int begun = 0, steps = 0, asked_after_no = 0;
  bool has_said_no = false;
  void on_flow_begin(const Mesh_view&, double) { ++begun; }
  void on_step_end(const CGP::Flow_step_report&, const Mesh_view&) { ++steps; }
  bool go_further()
  {
    asked_after_no += has_said_no;
    if (has_said_no || steps == 0) return true;
    has_said_no = true;
    return false;
  }
};

TEST(Components_that_are_cancelled, are_not_begun)
{
  const Joined_meshes all = interleaved({icosphere(1), moved(disk(3), {0, 0, 5})});
  Surface mesh = to_cgal_mesh<Surface>(all.mesh);
  Visitor_that_cancels visitor;
  const auto reports =
      CGP::spin_transform_components(mesh, rho_map(mesh), params::visitor(std::ref(visitor)));
  EXPECT_FALSE(reports);
  ASSERT_EQ(reports.components.size(), 2u);
  EXPECT_TRUE(reports.components[0].report.cancelled);
  EXPECT_TRUE(reports.components[1].report.cancelled);
  EXPECT_EQ(visitor.iterations, 1);
  EXPECT_EQ(view_of(mesh).positions(), all.mesh.positions());
}

TEST(Components_that_are_cancelled, stop_where_they_are_in_a_flow)
{
  const std::vector<Mesh_view> parts = {bumpy_sphere(1), moved(bumpy_sphere(1), {5, 0, 0}),
                                        moved(bumpy_sphere(1), {0, 5, 0})};
  const Joined_meshes all = interleaved(parts);
  Surface mesh = to_cgal_mesh<Surface>(all.mesh), alone = to_cgal_mesh<Surface>(parts[0]);
  Visitor_that_cancels_once visitor;
  const auto reports = CGP::conformal_willmore_flow_components(
      mesh, params::visitor(std::ref(visitor)).exact_conformal_class(false));
  EXPECT_FALSE(reports);
  ASSERT_EQ(reports.components.size(), 3u);
  for (std::size_t p = 0; p < 3; ++p) {
    EXPECT_EQ(reports.components[p].report.stop, CGP::Flow_step_report::Stop::cancelled);
    EXPECT_EQ(reports.components[p].report.steps.size(), p == 0 ? 1u : 0u);
  }
  EXPECT_EQ(visitor.begun, 1);
  EXPECT_EQ(visitor.asked_after_no, 0);
  ASSERT_TRUE(CGP::conformal_willmore_flow(
      alone, params::number_of_iterations(1).exact_conformal_class(false)));
  const Points points = view_of(mesh).positions();
  EXPECT_EQ(columns(points, all.vertices[0]), view_of(alone).positions());
  for (std::size_t p = 1; p < 3; ++p)
    EXPECT_EQ(columns(points, all.vertices[p]), parts[p].positions());
}

}  // namespace cgp_test::components_cancelled_tests
