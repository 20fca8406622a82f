// Tests include/Conformal_geometry_processing/flow/Conformal_willmore_flow.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Conformal_willmore_flow.h>

#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "flow_tools.h"
#include "support/handlebodies.h"
#include "support/moebius.h"

namespace cgp_test::conformal_willmore_flow_handles_tests {

/// The flow of surfaces with handles, which have to close up around them. The energies of the
/// reference runs come from an implementation of the same formulas that shares no code with this
/// one.

using CGP::Exactness;

struct Errors {
  std::vector<double> time_step, period, distortion;  // Q - 1
};

/// of one step from the same surface, for several time steps
Errors errors_of_one_step(const Mesh_view& mesh, std::optional<Exactness> version)
{
  Errors e;
  for (const double tau : {0.2, 0.1, 0.05}) {
    CGP::Flow_options options = plain_steps(tau, 1);
    options.surface.exactness = version;
    options.surface.max_period_defect = 1;  // the constraints alone
    CGP::Conformal_willmore_flow flow(mesh, options);
    const CGP::Flow_step_report step = flow.step();
    EXPECT_TRUE(step.accepted);
    e.time_step.push_back(tau);
    e.period.push_back(step.period_defect);
    e.distortion.push_back(step.quasi_conformal.mean - 1);
  }
  return e;
}

void expect_descent(const CGP::Flow_report& report)
{
  double energy = report.initial_energy;
  for (const auto& step : report.steps) {
    EXPECT_LT(step.energy, energy);
    energy = step.energy;
  }
}

/// root mean square of the change of the logarithms of the areas of vertices
double area_difference(const Mesh_view& a, const Mesh_view& b)
{
  const Eigen::ArrayXd u = (CGP::vertex_areas(a).array() / CGP::vertex_areas(b).array()).log();
  return std::sqrt((u - u.mean()).square().mean());
}

TEST(Conformal_willmore_flow_with_handles, closes_up_to_second_order)
{
  const Errors e = errors_of_one_step(btorus(24), Exactness::adjoint);
  EXPECT_NEAR(slope(e.time_step, e.period), 2, 0.05);
  EXPECT_NEAR(slope(e.time_step, e.distortion), 1, 0.05);
}

TEST(Conformal_willmore_flow_with_handles, closes_up_to_first_order_without_constraints)
{
  const Errors none = errors_of_one_step(btorus(24), {});
  const Errors thesis = errors_of_one_step(btorus(24), Exactness::thesis);
  EXPECT_NEAR(slope(none.time_step, none.period), 1, 0.05);
  EXPECT_LT(slope(thesis.time_step, thesis.period), 1.9);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_GT(none.period[i], 50 * thesis.period[i]);
    EXPECT_GT(none.distortion[i], 5 * thesis.distortion[i]);
  }
}

TEST(Conformal_willmore_flow_with_handles, distorts_in_proportion_to_the_step)
{
  for (const int genus : {2, 3}) {
    const Errors e = errors_of_one_step(smooth_handlebody(genus, 2), Exactness::adjoint);
    EXPECT_NEAR(slope(e.time_step, e.distortion), 1, 0.05) << genus;
    EXPECT_NEAR(slope(e.time_step, e.period), 2, 0.1) << genus;
  }
}

TEST(Conformal_willmore_flow_with_handles, closes_every_step_up_to_the_limit)
{
  for (const Mesh_view& mesh : {btorus(24), smooth_handlebody(2, 2)})
    for (const double limit : {1e-3, 1e-5}) {
      CGP::Flow_options options = plain_steps(.25, 2);
      options.surface.max_period_defect = limit;
      CGP::Conformal_willmore_flow flow(mesh, options);
      for (const CGP::Flow_step_report& step : flow.run().steps) {
        EXPECT_LE(step.period_defect, limit);
        EXPECT_EQ(step.period_defect, step.spin.period_defect);
      }
    }
}

TEST(Conformal_willmore_flow_with_handles, takes_a_torus_of_rectangular_class_to_the_clifford_torus)
{
  CGP::Flow_options options = plain_steps(1, 5);
  options.surface.max_period_defect = 1;  // as in the reference run
  CGP::Conformal_willmore_flow flow(storus(48), options);
  const CGP::Flow_report report = flow.run();
  const double expected[] = {0.99946, 0.99816, 0.99810, 0.99808, 0.99807};
  ASSERT_EQ(report.steps.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_NEAR(report.steps[i].energy / (2 * pi * pi), expected[i], 5e-5) << i;
  EXPECT_LT(report.steps.back().period_defect, 1e-6);
  EXPECT_LT(report.conformality.quasi_conformal.mean, 1.01);
}

TEST(Conformal_willmore_flow_with_handles, keeps_round_tori)
{
  CGP::Conformal_willmore_flow flow(torus(2.5, 1, 80, 40), plain_steps(1, 3));
  const double before = flow.energy();
  const CGP::Flow_report report = flow.run();
  EXPECT_EQ(report.steps.size(), 3U);
  EXPECT_NEAR(report.energy, before, 1e-6 * before);
  EXPECT_LT(report.conformality.quasi_conformal.max, 1.0001);
}

TEST(Conformal_willmore_flow_with_handles, smoothes_a_double_torus)
{
  CGP::Flow_options options;
  options.max_steps = 4;
  CGP::Conformal_willmore_flow flow(smooth_handlebody(2, 3), options);
  const CGP::Flow_report report = flow.run();
  EXPECT_TRUE(report);
  EXPECT_EQ(report.steps.size(), 4U);
  expect_descent(report);
  EXPECT_LT(report.energy, 0.75 * report.initial_energy);
  EXPECT_LT(report.conformality.quasi_conformal.mean, 1.06);
  EXPECT_EQ(report.conformality.flipped_faces, 0);
}

TEST(Conformal_willmore_flow_with_handles, comes_to_the_same_torus_after_an_inversion_if_balanced)
{
  const Mesh_view mesh = storus(32);
  const Mesh_view moved = scaled_to_area(inverted(mesh, {2.2, 0.5, 0.3}), 4 * pi);
  for (const CGP::Flow_options::Balancing balancing :
       {CGP::Flow_options::Balancing::inversion, CGP::Flow_options::Balancing::potential}) {
    CGP::Flow_options options = plain_steps(1, 4);
    options.balance = CGP::Flow_options::Balance::canonical;
    options.balancing = balancing;
    CGP::Conformal_willmore_flow one(mesh, options), other(moved, options);
    (void)one.run();
    const CGP::Flow_report report = other.run();
    options.balance = CGP::Flow_options::Balance::none;
    CGP::Conformal_willmore_flow adrift(moved, options);
    (void)adrift.run();
    const double difference = area_difference(one.mesh(), other.mesh());
    EXPECT_LT(difference, 0.15);
    EXPECT_GT(area_difference(one.mesh(), adrift.mesh()), 5 * difference);
    if (balancing == CGP::Flow_options::Balancing::inversion) expect_descent(report);
  }
}

TEST(Conformal_willmore_flow_with_handles, goes_back_on_itself_rather_than_tear_a_torus)
{
  // Without constraints, the energy decreases while the torus shears: only its distortion shows it.
  CGP::Flow_options options;
  options.surface.exactness.reset();
  options.max_steps = 1;
  options.max_step_distortion = 1.05;
  CGP::Conformal_willmore_flow flow(btorus(24), options);
  const CGP::Flow_step_report step = flow.step();
  EXPECT_TRUE(step.accepted);
  EXPECT_GE(step.trials, 3);
  EXPECT_LT(step.spin.conformality.quasi_conformal.mean, 1.05);
}

}  // namespace cgp_test::conformal_willmore_flow_handles_tests
