// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Spin_report_io.h
#include <Conformal_geometry_processing/spin/Spin_report_io.h>

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace cgp_test::spin_report_io_tests {

namespace CGP = Conformal_geometry_processing;

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
  using Fault = CGP::Spin_report::Fault;
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
  report.scales = {2, .625, 1.75, .5, 1.875, 10, .9375, .96875};
  EXPECT_TRUE(contains(printed(report),
                       "98 % of the area scaled by 0.625 to 1.75 with a bound of 2, 93.75 % of rho "
                       "kept, correlation 0.96875\n"))
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

}  // namespace cgp_test::spin_report_io_tests
