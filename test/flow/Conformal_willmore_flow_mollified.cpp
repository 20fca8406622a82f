// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/flow/Conformal_willmore_flow.h
#include <Conformal_geometry_processing/flow/Conformal_willmore_flow.h>
#include <Conformal_geometry_processing/measure/alignment.h>

#include <gtest/gtest.h>

#include <array>

#include "flow_tools.h"
#include "support/bounded_meshes.h"
#include "support/thin_faces.h"

namespace cgp_test::conformal_willmore_flow_mollified_tests {

CGP::Flow_options mollified(int steps, bool on_class = true)
{
  CGP::Flow_options options;
  options.max_steps = steps;
  options.surface.mollification = 1e-6;
  options.surface.exact_conformal_class = on_class;
  return options;
}

/// of the vertices that both have, by the diagonal
double distance(const Mesh_view& found, const Mesh_view& expected)
{
  const Eigen::Index n = expected.positions().cols();
  return CGP::align(Points(found.positions().leftCols(n)), expected.positions()).max;
}

TEST(Conformal_willmore_flow_mollified, of_a_Delaunay_mesh_begins_as_that_of_the_mesh)
{
  const Mesh_view mesh = bumpy_sphere(2);
  CGP::Flow_options plain = mollified(1, false);
  plain.surface.mollification.reset();
  CGP::Conformal_willmore_flow expected(mesh, plain), flow(mesh, mollified(1, false));
  EXPECT_NEAR(flow.energy(), expected.energy(), 1e-12 * expected.energy());
  const CGP::Flow_report a = expected.run(), b = flow.run();
  ASSERT_TRUE(a && b);
  EXPECT_NEAR(b.steps[0].direction_norm, a.steps[0].direction_norm, 1e-10);
  EXPECT_LT(distance(flow.mesh(), expected.mesh()), 1e-9);
  EXPECT_NEAR(flow.energy(), expected.energy(), 1e-2 * expected.energy());  // on flipped edges
}

TEST(Conformal_willmore_flow_mollified, rounds_a_sphere_with_flat_faces_as_the_clean_one)
{
  const Mesh_view clean = bumpy_sphere(3);
  for (const bool on_class : {true, false}) {
    CGP::Conformal_willmore_flow expected(clean, mollified(6, on_class));
    (void)expected.run();
    for (const double height : {1e-6, 0.}) {
      const Mesh_view mesh = with_thin_faces(clean, height);
      CGP::Conformal_willmore_flow flow(mesh, mollified(6, on_class));
      const CGP::Flow_report report = flow.run();
      ASSERT_TRUE(report);
      const int flips = report.steps.back().spin.mollification.flipped_edges;
      EXPECT_GT(flips, 100);
      EXPECT_LT(flips, mesh.size_of_edges() / 2);
      EXPECT_LT(report.energy, .9 * report.initial_energy);
      EXPECT_LT(report.conformality.quasi_conformal.mean, 1.03);
      EXPECT_LT(distance(flow.mesh(), expected.mesh()), .03);
    }
  }
  EXPECT_THROW(CGP::Conformal_willmore_flow{with_thin_faces(clean, 0)}, CGP::Precondition_error);
}

// Faces whose longest edge is flipped, points that coincide, and both among good faces.
TEST(Conformal_willmore_flow_mollified, makes_spheres_of_flat_faces_on_their_class)
{
  const Mesh_view clean = stretched(icosphere(3), 1.5);
  for (const Mesh_view& mesh : {with_thin_faces(clean, 0), with_thin_faces(clean, 0, 0),
                                with_thin_faces(perturbed(clean, .02), 0, .9)}) {
    CGP::Conformal_willmore_flow flow(mesh, mollified(20));
    const CGP::Flow_report report = flow.run();
    EXPECT_TRUE(report) << to_string(report.stop) << ' ' << report.message;
    for (const CGP::Flow_step_report& step : report.steps) {
      EXPECT_LE(step.length_cross_ratio, 1e-3);
      EXPECT_GT(step.spin.mollification.thin_faces, 100);
    }
    EXPECT_LT(report.conformality.length_cross_ratio.max, 1e-9);
    EXPECT_LT(report.energy, 1.02 * 4 * pi);
    EXPECT_LT(report.conformality_of_faces.quasi_conformal.mean, 1.05);
  }
}

// Vertices much nearer to each other than edges are long are creases of small scale to the flow,
// which it smooths first, and slowly.
TEST(Conformal_willmore_flow_mollified, goes_on_where_faces_are_folded)
{
  const Mesh_view mesh = spoilt(bumpy_sphere(2));
  CGP::Conformal_willmore_flow flow(mesh, mollified(3));
  const CGP::Flow_report report = flow.run();
  EXPECT_GE(report.steps.size(), 1U);
  EXPECT_LT(report.energy, .8 * report.initial_energy);
  EXPECT_TRUE(flow.mesh().positions().allFinite());
}

TEST(Conformal_willmore_flow_mollified, keeps_the_handle_of_a_torus_with_flat_faces)
{
  const Mesh_view mesh = with_thin_faces(torus(2, 1, 32, 16), 0);
  for (const bool on_class : {true, false}) {
    CGP::Conformal_willmore_flow flow(mesh, mollified(4, on_class));
    const CGP::Flow_report report = flow.run();
    ASSERT_TRUE(report);
    EXPECT_LT(report.energy, report.initial_energy);
    for (const CGP::Flow_step_report& step : report.steps) {
      EXPECT_LT(step.period_defect, 5e-3);
      EXPECT_LT(step.spin.closure_residual, .02);
    }
    EXPECT_LT(report.conformality.quasi_conformal.mean, 1.05);
    EXPECT_EQ(report.conformal_type_change > 0, on_class);  // it is not measured on sheets
  }
}

TEST(Conformal_willmore_flow_mollified, can_be_filtered_and_balanced)
{
  const Mesh_view mesh = with_thin_faces(torus(2, 1, 24, 12), 0);
  for (const bool on_class : {true, false}) {
    CGP::Flow_options options = mollified(2, on_class);
    options.filter_weight = .02;
    options.balance = CGP::Flow_options::Balance::initial;
    CGP::Conformal_willmore_flow flow(mesh, options);
    const CGP::Flow_report report = flow.run();
    EXPECT_TRUE(report);
    EXPECT_LT(report.energy, report.initial_energy);
  }
}

TEST(Conformal_willmore_flow_mollified, flattens_a_sheet_with_a_cap_at_its_boundary)
{
  const Mesh_view clean = mapped(disk(6), [](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(p.x(), p.y(), .1 * std::sin(3 * p.x()));
  });
  int h = 0;  // a halfedge at the boundary
  while (clean.twin(h) >= 0) ++h;
  Points p(3, clean.size_of_vertices() + 1);
  Corners corners = clean.corners();
  const int cap = Mesh_view::face(h);
  const std::array<int, 3> v = {clean.from(h), clean.to(h), corners[at(cap)][at(h % 3)]};
  const int apex = clean.size_of_vertices();
  p << clean.positions(), (clean.position(v[0]) + clean.position(v[1])) / 2;
  corners[at(cap)] = {v[0], v[1], apex};
  corners.push_back({v[1], v[2], apex});
  corners.push_back({v[2], v[0], apex});
  for (const bool on_class : {true, false}) {
    CGP::Conformal_willmore_flow flow(Mesh_view(p, corners), mollified(3, on_class));
    const CGP::Flow_report report = flow.run();
    EXPECT_TRUE(report);
    EXPECT_LT(report.energy, .05 * report.initial_energy);
  }
}

TEST(Conformal_willmore_flow_mollified, does_not_depend_on_scale)
{
  const Mesh_view mesh = with_thin_faces(bumpy_sphere(1), 0);
  for (const bool on_class : {true, false})
    for (const double scale : {1e-100, 1e90}) {
      CGP::Conformal_willmore_flow flow(scaled(mesh, scale), mollified(2, on_class)),
          expected(mesh, mollified(2, on_class));
      EXPECT_FALSE(flow.run().steps.empty());  // areas are not measured at such scales
      EXPECT_TRUE(expected.run());
      EXPECT_NEAR(flow.energy(), expected.energy(), 1e-6 * expected.energy());
    }
}

}  // namespace cgp_test::conformal_willmore_flow_mollified_tests
