// Tests include/Conformal_geometry_processing/flow/Conformal_willmore_flow.h
// Tests include/Conformal_geometry_processing/flow/Class_keeper.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Conformal_willmore_flow.h>
#include <Conformal_geometry_processing/mesh/Boundary_frames.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "bounded_flows.h"
#include "support/random.h"

namespace cgp_test::flow_on_class_boundary_tests {

/// Laws of the flow on the exact discrete conformal class with a boundary.

using Flow = CGP::Conformal_willmore_flow;

struct Flown {
  Flown(const Mesh_view& mesh, const Boundary_condition& condition, bool is_exact, int steps = 20)
      : flow(mesh, options(condition, is_exact, steps)), report(flow.run())
  {}

  static CGP::Flow_options options(const Boundary_condition& condition, bool is_exact, int steps)
  {
    CGP::Flow_options options;
    options.boundary = condition;
    options.exact_conformal_class = is_exact;
    options.max_steps = steps;
    return options;
  }

  /// the mean angle between the first and the last directions of the boundary, in degrees
  double drift(const Boundary_condition& condition) const
  {
    const auto first = CGP::boundary_frames(flow.initial_mesh()),
               last = CGP::boundary_frames(flow.mesh());
    double sum = 0;
    for (std::size_t k = 0; k < first.frames.size(); ++k) {
      const Eigen::Vector3d a = first.frames[k] * condition.direction,
                            b = last.frames[k] * condition.direction;
      sum += std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / pi;
    }
    return sum / double(first.frames.size());
  }

  Flow flow;
  CGP::Flow_report report;
};

std::vector<Boundary_condition> conditions()
{
  return {Boundary_condition::free(), Boundary_condition::tangents(),
          Boundary_condition::binormals()};
}

TEST(Flow_on_class_with_boundary, keeps_length_cross_ratios_of_disks_and_rings)
{
  for (const Mesh_view& mesh : {bumpy_cap(8), bumpy_annulus(5), perturbed(bumpy_cap(8), .01)})
    for (const Boundary_condition& condition : conditions()) {
      const Flown run(mesh, condition, true, 5);
      EXPECT_LT(run.report.conformality.length_cross_ratio.max, 1e-10);
      EXPECT_LT(run.report.energy, .9 * run.report.initial_energy);
      for (const CGP::Flow_step_report& step : run.report.steps) {
        EXPECT_LE(step.length_cross_ratio, 1e-3);
        EXPECT_LT(step.energy, step.energy_before);
      }
    }
}

TEST(Flow_on_class_with_boundary, keeps_the_first_tangents_and_binormals)
{
  for (const Mesh_view& mesh : {bumpy_cap(12), bumpy_annulus(8)})
    for (const Boundary_condition& condition :
         {Boundary_condition::tangents(), Boundary_condition::binormals()}) {
      const double exact = Flown(mesh, condition, true).drift(condition),
                   plain = Flown(mesh, condition, false).drift(condition);
      EXPECT_LT(exact, .5);
      EXPECT_LT(exact, .4 * plain);
    }
}

TEST(Flow_on_class_with_boundary, tells_how_far_directions_are_from_the_first)
{
  for (const Boundary_condition& condition :
       {Boundary_condition::tangents(), Boundary_condition::binormals()})
    for (const int steps : {1, 4, 20}) {
      const Flown run(bumpy_annulus(5), condition, true, steps);
      const CGP::Spin_report& last = run.report.steps.back().spin;
      EXPECT_NEAR(last.direction_error.mean * 180 / pi, run.drift(condition), .01);
      EXPECT_GE(last.direction_error.max, last.direction_error.mean);
    }
}

TEST(Flow_on_class_with_boundary, comes_nearer_to_minimal_surfaces)
{
  for (const Mesh_view& mesh : {bumpy_cap(12), bumpy_annulus(8)})
    for (const Boundary_condition& condition :
         {Boundary_condition::free(), Boundary_condition::tangents()}) {
      const Flown exact(mesh, condition, true), plain(mesh, condition, false);
      EXPECT_LT(exact.report.energy, .95 * plain.report.energy);
      EXPECT_LT(exact.report.energy, .01 * exact.report.initial_energy);
    }
}

// The faces there are as noisy as the rest.
TEST(Flow_on_class_with_boundary, takes_noise_away_that_the_plain_flow_leaves)
{
  const Mesh_view mesh = perturbed(bumpy_cap(16), .01);
  for (const Boundary_condition& condition : conditions()) {
    const Flown exact(mesh, condition, true), plain(mesh, condition, false);
    EXPECT_LT(exact.report.energy, .6 * plain.report.energy);
    EXPECT_LT(exact.report.conformality.quasi_conformal.mean, 1.04);
    EXPECT_GT(plain.report.conformality.quasi_conformal.mean, 1.4);
  }
}

TEST(Flow_on_class_with_boundary, turns_a_hemisphere_to_prescribed_binormals)
{
  const Mesh_view hemisphere = cap_from_disk(disk(12), pi / 2);
  const auto frames = CGP::boundary_frames(hemisphere);
  Boundary_condition condition = Boundary_condition::binormals();
  condition.targets.resize(3, static_cast<Eigen::Index>(frames.frames.size()));
  for (std::size_t k = 0; k < frames.frames.size(); ++k) {
    const Eigen::Vector3d p = hemisphere.position(frames.vertices[k]);
    condition.targets.col(static_cast<Eigen::Index>(k)) =
        .5 * Eigen::Vector3d(p.x(), p.y(), 0).normalized() -
        std::sqrt(.75) * Eigen::Vector3d::UnitZ();
  }
  const Flown run(hemisphere, condition, true);
  EXPECT_TRUE(run.report.converged())
      << CGP::to_string(run.report.stop) << ' ' << run.report.message;
  EXPECT_LT(run.report.conformality.length_cross_ratio.max, 1e-10);
  EXPECT_NEAR(run.report.energy, pi, .08 * pi);
}

}  // namespace cgp_test::flow_on_class_boundary_tests
