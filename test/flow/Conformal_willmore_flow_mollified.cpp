// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/flow/Conformal_willmore_flow.h
#include <Conformal_geometry_processing/flow/Conformal_willmore_flow.h>
#include <Conformal_geometry_processing/measure/alignment.h>

#include <gtest/gtest.h>

#include "flow_tools.h"
#include "support/bounded_meshes.h"
#include "support/thin_faces.h"

namespace {

using namespace cgp_test;

CGP::Flow_options mollified(int steps)
{
  CGP::Flow_options options;
  options.max_steps = steps;
  options.mollification = 1e-6;
  return options;
}

/// of the vertices that both have, by the diagonal
double distance(const Mesh_view& found, const Mesh_view& expected)
{
  const Eigen::Index n = expected.positions().cols();
  return CGP::align(Points(found.positions().leftCols(n)), expected.positions()).max;
}

}  // namespace

TEST(Conformal_willmore_flow_mollified, of_a_Delaunay_mesh_begins_as_that_of_the_mesh)
{
  const Mesh_view mesh = bumpy_sphere(2);
  CGP::Flow_options plain = mollified(1);
  plain.mollification.reset();
  CGP::Conformal_willmore_flow<> expected(mesh, plain), flow(mesh, mollified(1));
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
  CGP::Conformal_willmore_flow<> expected(clean, mollified(6));
  (void)expected.run();
  for (const double height : {1e-6, 0.}) {
    const Mesh_view mesh = with_thin_faces(clean, height);
    CGP::Conformal_willmore_flow<> flow(mesh, mollified(6));
    const CGP::Flow_report report = flow.run();
    ASSERT_TRUE(report);
    EXPECT_GT(report.steps.back().spin.mollification.flipped_edges, 100);
    EXPECT_LT(report.energy, .9 * report.initial_energy);
    EXPECT_LT(report.conformality.quasi_conformal.mean, 1.03);
    EXPECT_LT(distance(flow.mesh(), expected.mesh()), .03);
  }
  EXPECT_THROW(CGP::Conformal_willmore_flow<>{with_thin_faces(clean, 0)}, CGP::Precondition_error);
}

// Vertices much nearer to each other than edges are long are creases of small scale to the flow,
// which it smooths first, and slowly.
TEST(Conformal_willmore_flow_mollified, goes_on_where_faces_are_folded)
{
  const Mesh_view mesh = spoilt(bumpy_sphere(2));
  CGP::Conformal_willmore_flow<> flow(mesh, mollified(3));
  const CGP::Flow_report report = flow.run();
  EXPECT_GE(report.steps.size(), 1U);
  EXPECT_LT(report.energy, .8 * report.initial_energy);
  EXPECT_TRUE(flow.mesh().positions().allFinite());
}

TEST(Conformal_willmore_flow_mollified, keeps_the_handle_of_a_torus_with_flat_faces)
{
  const Mesh_view mesh = with_thin_faces(torus(2, 1, 32, 16), 0);
  CGP::Conformal_willmore_flow<> flow(mesh, mollified(4));
  const CGP::Flow_report report = flow.run();
  ASSERT_TRUE(report);
  EXPECT_LT(report.energy, report.initial_energy);
  for (const CGP::Flow_step_report& step : report.steps) {
    EXPECT_LT(step.period_defect, 5e-3);
    EXPECT_LT(step.spin.closure_residual, .02);
  }
  EXPECT_LT(report.conformality.quasi_conformal.mean, 1.05);
}

TEST(Conformal_willmore_flow_mollified, can_be_filtered_and_balanced)
{
  const Mesh_view mesh = with_thin_faces(torus(2, 1, 24, 12), 0);
  CGP::Flow_options options = mollified(2);
  options.filter_weight = .02;
  options.balance = CGP::Balance::initial;
  CGP::Conformal_willmore_flow<> flow(mesh, options);
  const CGP::Flow_report report = flow.run();
  EXPECT_TRUE(report);
  EXPECT_LT(report.energy, report.initial_energy);
}
