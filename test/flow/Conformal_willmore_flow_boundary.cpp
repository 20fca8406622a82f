// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/flow/Conformal_willmore_flow.h
#include <Conformal_geometry_processing/flow/Conformal_willmore_flow.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "bounded_flows.h"

namespace cgp_test::conformal_willmore_flow_boundary_tests {

/// Disks with free boundary, and with tangents or binormals that are kept.

/// of the reference runs, after each step without backtracking
std::vector<double> energies(double time_step, int steps, const Boundary_condition& condition)
{
  CGP::Conformal_willmore_flow flow(bumpy_cap(24), plain_steps(time_step, steps, condition),
                                    Barycentric_direction());
  EXPECT_NEAR(flow.energy(), 3.7809, 1e-4);
  std::vector<double> list;
  for (const auto& step : flow.run().steps) list.push_back(step.energy);
  return list;
}

void expect_numbers(const std::vector<double>& found, const std::vector<double>& expected,
                    double tolerance)
{
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_NEAR(found[i], expected[i], tolerance) << "step " << i + 1;
}

/// the default options with this condition
CGP::Flow_report flown(const Mesh_view& mesh, const Boundary_condition& condition,
                       bool is_exact = true)
{
  CGP::Flow_options options;
  options.surface.boundary = condition;
  options.surface.exact_conformal_class = is_exact;
  CGP::Conformal_willmore_flow flow(mesh, options);
  return flow.run();
}

void expect_falling(const CGP::Flow_report& report)
{
  double energy = report.initial_energy;
  for (const auto& step : report.steps) {
    EXPECT_LT(step.energy, energy);
    energy = step.energy;
  }
}

TEST(Conformal_willmore_flow_with_boundary,
     with_tangents_multiplies_the_energy_by_1_minus_tau_squared)
{
  const double digits = 1e-4;
  expect_numbers(energies(.25, 4, Boundary_condition::tangents()), {2.1356, 1.2052, .6799, .3835},
                 digits);
  expect_numbers(energies(.5, 3, Boundary_condition::tangents()), {.9555, .2408, .0607}, digits);
  EXPECT_LE(energies(1, 1, Boundary_condition::tangents())[0], 3.5e-4);
}

TEST(Conformal_willmore_flow_with_boundary, with_tangents_is_stable_up_to_two)
{
  expect_numbers(energies(1.9, 3, Boundary_condition::tangents()), {3.0158, 2.4036, 1.9218}, 1e-4);
  expect_numbers(energies(2.1, 3, Boundary_condition::tangents()), {4.5066, 5.3554, 6.3858}, 1e-4);
}

TEST(Conformal_willmore_flow_with_boundary, with_a_free_boundary_is_as_fast_and_as_stable)
{
  const double percent = 3e-3;
  expect_numbers(energies(.25, 3, Boundary_condition::free()), {2.1793, 1.2543, .7212}, percent);
  expect_numbers(energies(.5, 3, Boundary_condition::free()), {1.0134, .2701, .0719}, percent);
  EXPECT_LE(energies(1, 1, Boundary_condition::free())[0], 5.4e-3);
  expect_numbers(energies(1.9, 2, Boundary_condition::free()), {2.5957, 1.8157}, percent);
  const std::vector<double> unstable = energies(2.1, 3, Boundary_condition::free());
  EXPECT_GT(unstable[0], 3.7809);
  EXPECT_TRUE(std::is_sorted(unstable.begin(), unstable.end()));
}

TEST(Conformal_willmore_flow_with_boundary, with_binormals_ends_at_constant_mean_curvature)
{
  const std::vector<double> found = energies(1, 10, Boundary_condition::binormals());
  expect_numbers({found[0], found[1], found[2], found[3], found[9]},
                 {3.0157, 3.0026, 3.0001, 2.9993, 2.9989}, 1e-4);
}

TEST(Conformal_willmore_flow_with_boundary, stops_at_a_minimal_surface)
{
  for (const Boundary_condition& condition :
       {Boundary_condition::tangents(), Boundary_condition::free()}) {
    const CGP::Flow_report report = flown(bumpy_cap(12), condition);
    EXPECT_TRUE(report.converged()) << to_string(report.stop) << " " << report.message;
    EXPECT_LE(report.energy, 1e-4 * report.initial_energy);
    EXPECT_LT(report.steps.size(), 10U);
    EXPECT_LT(report.conformality.quasi_conformal.mean, 1.03);
    expect_falling(report);
  }
}

TEST(Conformal_willmore_flow_with_boundary, stops_at_constant_mean_curvature)
{
  const CGP::Flow_report report = flown(bumpy_cap(12), Boundary_condition::binormals(), false);
  EXPECT_EQ(report.stop, CGP::Flow_step_report::Stop::energy_settled);
  EXPECT_NEAR(report.energy, 2.99, .03);
  expect_falling(report);
}

// The first binormals, which it keeps, are those of faces: first order. What a step misses of them
// may raise the energy while the deviation of H falls.
TEST(Conformal_willmore_flow_with_boundary, on_the_exact_class_tends_to_constant_mean_curvature)
{
  std::vector<double> excess;
  for (const int n : {12, 24}) {
    const CGP::Flow_report report = flown(bumpy_cap(n), Boundary_condition::binormals());
    EXPECT_EQ(report.stop, CGP::Flow_step_report::Stop::energy_settled) << report.message;
    excess.push_back(report.energy - 2.9989);
    for (const CGP::Flow_step_report& step : report.steps)
      EXPECT_TRUE(step.energy < step.energy_before ||
                  step.direction_norm_after < .9 * step.direction_norm);
    EXPECT_LT(report.direction_norm, .02 * std::sqrt(report.energy));
    EXPECT_LT(report.direction_norm, .05 * report.steps.front().direction_norm);
  }
  EXPECT_LT(excess[0], .13);
  EXPECT_LT(excess[1], .55 * excess[0]);
}

TEST(Conformal_willmore_flow_with_boundary, keeps_a_cap_and_loses_its_bumps_by_a_filter)
{
  for (const Boundary_condition& condition :
       {Boundary_condition::tangents(), Boundary_condition::binormals(),
        Boundary_condition::free()}) {
    CGP::Flow_options options = plain_steps(1, 5, condition);
    options.filter_weight = .05;
    options.filter_order = 2;
    CGP::Conformal_willmore_flow flow(bumpy_cap(12), options);
    EXPECT_GT(flow.energy(), 3.7);
    EXPECT_TRUE(flow.run());
    EXPECT_NEAR(flow.energy(), pi, .1 * pi);  // energy of the round cap
  }
}

TEST(Conformal_willmore_flow_with_boundary, has_nothing_to_do_on_a_plane)
{
  // Turned, so that the curvatures are rounding, which no step makes less.
  const Eigen::Matrix3d R =
      Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const Mesh_view flat = mapped(disk(6), [&](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(R * p + Eigen::Vector3d(1, 5, 2));
  });
  for (const Boundary_condition& condition :
       {Boundary_condition::tangents(), Boundary_condition::binormals(),
        Boundary_condition::free()}) {
    const CGP::Flow_report report = flown(flat, condition);
    EXPECT_EQ(report.stop, CGP::Flow_step_report::Stop::direction_vanished) << report.message;
    EXPECT_TRUE(report.steps.empty());
  }
}

TEST(Conformal_willmore_flow_with_boundary, tells_how_well_directions_are_kept)
{
  const auto order = [](const Boundary_condition& condition) {
    std::vector<double> sizes, errors;
    for (const int n : {16, 32}) {
      CGP::Conformal_willmore_flow flow(bumpy_cap(n), plain_steps(.5, 1, condition));
      const CGP::Flow_step_report step = flow.step();
      EXPECT_TRUE(step.accepted);
      EXPECT_TRUE(step.spin);
      EXPECT_GE(step.spin.direction_error.max, step.spin.direction_error.mean);
      EXPECT_EQ(step.period_defect, 0);
      sizes.push_back(1. / n);
      errors.push_back(step.spin.direction_error.mean);
    }
    EXPECT_LT(errors.back(), 5e-3);
    return slope(sizes, errors);
  };
  EXPECT_NEAR(order(Boundary_condition::tangents()), 2, .1);
  EXPECT_NEAR(order(Boundary_condition::binormals()), 1, .15);  // for normals of vertices are
}

}  // namespace cgp_test::conformal_willmore_flow_boundary_tests
