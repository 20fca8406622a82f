// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Spin_report.h
#include <Conformal_geometry_processing/spin/Spin_report.h>

#include <gtest/gtest.h>

#include <limits>

namespace cgp_test::spin_report_tests {

namespace CGP = Conformal_geometry_processing;

TEST(Spin_report, of_two_mollified_steps_tells_what_was_measured_in_the_first)
{
  CGP::Spin_report all, next;
  next.mollification = {1e-6, 1, 2, .5, 3, 40, .75};
  CGP::append(all, next);
  next.mollification = {1e-6, 2, 1, .25, 4, 30, .5};
  CGP::append(all, next);
  EXPECT_EQ(all.mollification.measured_faces, 40);
  EXPECT_EQ(all.mollification.measured_area, .75);
  EXPECT_EQ(all.mollification.thin_faces, 2);
  EXPECT_EQ(all.mollification.flipped_edges, 4);
}

TEST(Spin_report, of_two_transformations_adds_what_was_spent_and_keeps_the_worse_evidence)
{
  CGP::Spin_report all, next;
  all.steps = 2;
  all.iterations = 10;
  all.period_defect = .25;
  all.residual = 1e-9;
  all.gap = 3;
  next.steps = 3;
  next.iterations = 7;
  next.period_defect = .5;
  next.residual = 1e-8;
  next.gap = 4;
  CGP::append(all, next);
  EXPECT_EQ(all.steps, 5);
  EXPECT_EQ(all.iterations, 17);
  EXPECT_EQ(all.period_defect, .75);
  EXPECT_EQ(all.residual, 1e-8);
  EXPECT_EQ(all.gap, 3);
}

TEST(Spin_report, objects_to_open_handles)
{
  CGP::Spin_report report;
  report.converged = true;
  report.period_defect = .03;
  EXPECT_TRUE(report);
  report.period_limit = .02;
  EXPECT_EQ(report.fault(), CGP::Spin_report::Fault::open);
  report.period_limit = .04;
  EXPECT_TRUE(report);
}

TEST(Spin_report, of_two_transformations_adds_all_costs)
{
  CGP::Spin_report all, next;
  all.factorizations = 2;
  all.solves = 30;
  all.seconds.factorization = .5;
  all.seconds.reconstruction = 2;
  next.factorizations = 3;
  next.solves = 5;
  next.seconds.setup = 8;
  next.seconds.factorization = .25;
  next.seconds.certificate = 4;
  all.seconds.exactness = 1;
  next.seconds.exactness = 3;
  CGP::append(all, next);
  EXPECT_EQ(all.factorizations, 5);
  EXPECT_EQ(all.solves, 35);
  EXPECT_EQ(all.seconds.setup, 8);
  EXPECT_EQ(all.seconds.factorization, .75);
  EXPECT_EQ(all.seconds.reconstruction, 2);
  EXPECT_EQ(all.seconds.certificate, 4);
  EXPECT_EQ(all.seconds.exactness, 4);
}

TEST(Spin_report, of_several_transformations_has_the_least_gap_that_is_known)
{
  CGP::Spin_report all, next;
  next.gap = 4;
  CGP::append(all, next);
  EXPECT_EQ(all.gap, 4);
  next.gap = 0;
  CGP::append(all, next);
  EXPECT_EQ(all.gap, 4);
}

using Fault = CGP::Spin_report::Fault;

CGP::Spin_report success()
{
  CGP::Spin_report report;
  report.converged = true;
  return report;
}

void expect_fault(const CGP::Spin_report& report, Fault fault)
{
  EXPECT_EQ(report.fault(), fault) << to_string(fault);
  EXPECT_EQ(static_cast<bool>(report), fault == Fault::none);
}

TEST(Spin_report, is_a_success_without_fault_only)
{
  CGP::Spin_report report = success();
  expect_fault(report, Fault::none);
  report.closure_residual = 0.2;
  expect_fault(report, Fault::open);
  report.realised_share = 0.05;
  expect_fault(report, Fault::left_out);
  report.direction_error.mean = 0.5;
  expect_fault(report, Fault::directions);
  report.boundary_fault = CGP::Spin_report::Boundary_fault::degenerate;
  expect_fault(report, Fault::boundary);
  report.converged = false;
  expect_fault(report, Fault::not_solved);
  report.eigenvalue = std::numeric_limits<double>::quiet_NaN();
  expect_fault(report, Fault::not_finite);
  report.steps = 0;
  expect_fault(report, Fault::nothing_left);
  report.cancelled = true;
  expect_fault(report, Fault::cancelled);
}

TEST(Spin_report, does_not_want_edges_to_close_up_where_positions_are_prescribed)
{
  CGP::Spin_report report = success();
  report.closure_residual = 0.2;
  report.has_positions = true;
  expect_fault(report, Fault::none);
  report.conformality.quasi_conformal_of_new_area = 2;
  expect_fault(report, Fault::map);
}

// A tolerance of 1e300 makes every vector converge.
TEST(Spin_report, is_no_success_with_a_large_residual_whatever_was_asked_for)
{
  CGP::Spin_report report = success();
  report.residual = 1e-3;
  expect_fault(report, Fault::not_solved);
}

TEST(Spin_report, is_no_success_if_the_map_is_not_conformal)
{
  CGP::Spin_report report = success();
  report.conformality.quasi_conformal_of_new_area = 2;
  expect_fault(report, Fault::map);
}

TEST(Spin_report, falls_short_where_the_curvature_has_changed_otherwise)
{
  CGP::Spin_report report;
  EXPECT_FALSE(report.falls_short());  // not measured
  for (const double share : {.8, 5.}) {
    report.realised_curvature = CGP::Realised_curvature{};
    report.realised_curvature->share = share;
    report.realised_curvature->correlation = .9;
    EXPECT_FALSE(report.falls_short());
    report.realised_curvature->correlation = .4;
    EXPECT_TRUE(report.falls_short());
    report.limits.agreement = .3;
    EXPECT_FALSE(report.falls_short());
    report.limits.agreement = .5;
    report.realised_curvature->correlation = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(report.falls_short());
  }
}

}  // namespace cgp_test::spin_report_tests
