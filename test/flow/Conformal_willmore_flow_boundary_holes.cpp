// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/flow/Conformal_willmore_flow.h
#include <Conformal_geometry_processing/flow/Conformal_willmore_flow.h>

#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "bounded_flows.h"

namespace cgp_test::conformal_willmore_flow_boundary_holes_tests {

/// Surfaces whose edges must close up around holes.

const std::vector<Boundary_condition>& conditions()
{
  static const std::vector<Boundary_condition> list = {
      Boundary_condition::binormals(), Boundary_condition::tangents(), Boundary_condition::free()};
  return list;
}

/// Gap around the hole of the annulus after each step, relative to the edge length
std::vector<double> gaps(const Boundary_condition& condition, bool is_constrained,
                         const std::vector<double>& time_steps)
{
  std::vector<double> list;
  for (const double tau : time_steps) {
    CGP::Flow_options options = plain_steps(tau, 1, condition);
    options.surface.dirac.tolerance = 1e-10;
    options.surface.max_period_defect = 1;  // the constraints alone
    if (!is_constrained) options.surface.exactness.reset();
    CGP::Conformal_willmore_flow flow(bumpy_annulus(10), options);
    list.push_back(flow.step().period_defect);
  }
  return list;
}

CGP::Flow_report three_steps(const Boundary_condition& condition, bool is_constrained)
{
  CGP::Flow_options options = plain_steps(.25, 3, condition);
  if (!is_constrained) options.surface.exactness.reset();
  CGP::Conformal_willmore_flow flow(bumpy_annulus(10), options);
  return flow.run();
}

TEST(Conformal_willmore_flow_with_holes, leaves_a_gap_of_second_order)
{
  const std::vector<double> steps = {.2, .1, .05, .025};
  for (const Boundary_condition& condition : conditions()) {
    const std::vector<double> found = gaps(condition, true, steps);
    EXPECT_NEAR(slope(steps, found), 2, .1);
    EXPECT_LT(found.back(), 1e-5);
  }
}

TEST(Conformal_willmore_flow_with_holes, leaves_a_gap_of_first_order_without_constraints)
{
  const std::vector<double> steps = {.05, .025, .0125};
  for (const Boundary_condition& condition : conditions()) {
    const std::vector<double> found = gaps(condition, false, steps);
    EXPECT_NEAR(slope(steps, found), 1, .1);
    EXPECT_GT(found.back(), 1e-5);
  }
}

TEST(Conformal_willmore_flow_with_holes, is_conformal_thanks_to_the_constraints)
{
  for (const Boundary_condition& condition : conditions()) {
    const CGP::Flow_report with = three_steps(condition, true);
    const CGP::Flow_report without = three_steps(condition, false);
    ASSERT_EQ(with.steps.size(), 3U);
    ASSERT_EQ(without.steps.size(), 3U);
    double energy = with.initial_energy;
    for (const auto& step : with.steps) {
      EXPECT_LT(step.energy, .8 * energy);
      EXPECT_TRUE(step.spin);
      energy = step.energy;
    }
    const double distortion = with.conformality.quasi_conformal.mean - 1;
    EXPECT_LT(distortion, 4e-3);
    EXPECT_GT(without.conformality.quasi_conformal.mean - 1, 1.15 * distortion);
  }
}

TEST(Conformal_willmore_flow_with_holes, without_constraints_shears_an_annulus_of_given_binormals)
{
  const CGP::Flow_report report = three_steps(Boundary_condition::binormals(), false);
  EXPECT_GT(report.conformality.quasi_conformal.mean, 1.05);
}

TEST(Conformal_willmore_flow_with_holes, arrives_where_little_changes)
{
  const std::optional<double> constraints_alone = 1, closed = std::nullopt;
  for (const std::optional<double> limit : {constraints_alone, closed})
    for (const Boundary_condition& condition : conditions()) {
      CGP::Flow_options options;
      options.surface.boundary = condition;
      options.energy_tolerance = .01;  // afterwards, constraint violations dominate
      options.surface.max_period_defect = limit;
      CGP::Conformal_willmore_flow flow(bumpy_annulus(8), options);
      const CGP::Flow_report report = flow.run();
      EXPECT_TRUE(report.converged()) << to_string(report.stop) << " " << report.message;
      EXPECT_LT(report.conformality.quasi_conformal.mean, 1.02);
      EXPECT_LT(report.energy, .25 * report.initial_energy);
      EXPECT_LT(report.steps.size(), limit ? 20U : 25U);  // open steps go a little further
    }
}

}  // namespace cgp_test::conformal_willmore_flow_boundary_holes_tests
