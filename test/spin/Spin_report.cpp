// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Spin_report.h>

#include <gtest/gtest.h>

#include <limits>
#include <sstream>
#include <string>

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

TEST(Spin_report, objects_to_more_curvature_than_that_of_a_sphere_beside_rho)
{
  CGP::Spin_report report;
  report.converged = true;
  report.radius = .5;
  for (const double sign : {-1, 1}) {
    report.limits_gamma = true;
    report.eigenvalue = 3.98 * sign;
    EXPECT_TRUE(report);
    report.eigenvalue = 4.02 * sign;
    EXPECT_EQ(report.fault(), CGP::Spin_report::Fault::curvature);
    report.limits_gamma = false;  // constants may be anything
    EXPECT_TRUE(report);
  }
  report.limits_gamma = true;
  report.radius = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(report);
  CGP::Spin_report all;
  report.radius = .5;
  report.eigenvalue = 1;
  CGP::append(all, report);
  EXPECT_EQ(all.gamma_radius(), .5);
  EXPECT_TRUE(all.limits_gamma);
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

std::string printed(const CGP::Spin_report& report)
{
  std::ostringstream out;
  out << report;
  return out.str();
}

bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

TEST(Spin_report_io, prints_the_numbers_that_prove_a_transformation)
{
  CGP::Spin_report report;
  report.converged = true;
  report.residual = 1.25e-9;
  report.eigenvalue = -0.375;
  report.closure_residual = 0.0625;
  report.conformality.quasi_conformal = {1.015625, 1.03125, 1.0625};
  report.conformality.length_cross_ratio = {0.002, 0.005};
  report.conformality.scale.min_scale = 0.5;
  report.conformality.scale.max_scale = 3;
  report.conformality.flipped_faces = 7;
  const std::string text = printed(report);
  for (const char* part :
       {"solved, residual 1.25e-09", "-0.375", "0.0625 of the edge lengths", "1.01562 mean",
        "1.03125 for 99 %", "1.0625 at most", "0.002 rms", "0.5 to 3", "faces          7\n"})
    EXPECT_TRUE(contains(text, part)) << part << " is missing in\n" << text;
}

TEST(Spin_report_io, says_when_the_equation_is_not_solved)
{
  EXPECT_TRUE(contains(printed(CGP::Spin_report{}), "NOT solved"));
}

TEST(Spin_report_io, tells_the_reason_of_every_failure)
{
  using Boundary_fault = CGP::Spin_report::Boundary_fault;
  CGP::Spin_report report;
  const auto expect_last_line = [&](Fault fault, const std::string& detail = "") {
    EXPECT_EQ(report.fault(), fault);
    const std::string line = std::string("\nfault                  ") + to_string(fault) + detail;
    EXPECT_TRUE(contains(printed(report), line + "\n")) << line << " is missing in\n"
                                                        << printed(report);
  };
  expect_last_line(Fault::not_solved);
  report.converged = true;
  expect_last_line(Fault::none);
  report.conformality.flipped_share = .5;
  expect_last_line(Fault::map, ": too many faces are flipped");
  report.period_defect = 1;
  report.period_limit = .01;
  expect_last_line(Fault::open);
  report.realised_share = .05;
  expect_last_line(Fault::left_out);
  report.direction_error = {.5, .75};
  expect_last_line(Fault::directions);
  EXPECT_TRUE(contains(printed(report), "missed by 0.5 radians in the mean, 0.75 at most\n"));
  for (const Boundary_fault fault : {Boundary_fault::not_realizable, Boundary_fault::degenerate}) {
    report.boundary_fault = fault;
    expect_last_line(Fault::boundary, std::string(": ") + to_string(fault));
  }
  report.steps = 0;
  expect_last_line(Fault::nothing_left);
  report.cancelled = true;
  report.converged = false;
  expect_last_line(Fault::cancelled);
  EXPECT_TRUE(contains(printed(report), "equation         cancelled, residual"));
}

TEST(Spin_report_io, tells_what_was_realised_of_rho_where_some_was_left_out)
{
  CGP::Spin_report report;
  EXPECT_FALSE(contains(printed(report), "handles kept closed"));
  report.missing_share = .75;
  report.realised_share = .625;
  EXPECT_TRUE(contains(printed(report), "62.5 % of rho realised and 75 % left out, by norm\n"));
}

TEST(Spin_report_io, tells_the_distances_from_positions)
{
  CGP::Spin_report report;
  EXPECT_FALSE(contains(printed(report), "missed"));
  report.position_error = {.25, .5};
  EXPECT_TRUE(contains(printed(report), "positions              missed by 0.25 in the mean, 0.5"));
}

TEST(Spin_report_io, tells_what_control_of_scale_has_kept)
{
  CGP::Spin_report report;
  EXPECT_FALSE(contains(printed(report), "scale control"));
  report.scales = {2, .625, 1.75, .5625, 1.875, .5, 1.9375, 10, .9375, .96875};
  EXPECT_TRUE(contains(
      printed(report),
      "98 % of the area scaled by 0.625 to 1.75, tips by 0.5625 to 1.875, with a bound of 2, "
      "93.75 % of rho kept, correlation 0.96875\n"))
      << printed(report);
}

TEST(Spin_report_io, tells_the_substeps_only_where_there_were_some)
{
  CGP::Spin_report report;
  EXPECT_FALSE(contains(printed(report), "substeps"));
  report.substeps = 3;
  EXPECT_TRUE(contains(printed(report), "in 3 substeps"));
}

TEST(Spin_report_io, prints_the_realised_change_of_curvature)
{
  CGP::Spin_report report;
  EXPECT_FALSE(contains(printed(report), "change of curvature"));
  report.realised_curvature = CGP::Realised_curvature{};
  report.realised_curvature->share = .75;
  report.realised_curvature->correlation = .5;
  report.realised_curvature->wrong_sign = .125;
  EXPECT_TRUE(
      contains(printed(report),
               "change of curvature    75 % of rho, correlation 0.5, wrong sign on 12.5 %"));
}

}  // namespace cgp_test::spin_report_tests
