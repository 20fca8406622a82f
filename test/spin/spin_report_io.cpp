// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Spin_report_io.h
#include <Conformal_geometry_processing/spin/Spin_report_io.h>

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace CGP = Conformal_geometry_processing;

namespace {

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

}  // namespace

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
