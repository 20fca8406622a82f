// Tests examples/conformal/report/verification.cpp examples/conformal/report/certificate.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/report/verification.h"

#include <gtest/gtest.h>

#include <limits>

namespace cgp_test::verification_tests {

namespace CGP = Conformal_geometry_processing;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// a report that nobody objects to
CGP::Spin_report faultless()
{
  CGP::Spin_report report;
  report.converged = true;
  report.steps = 1;
  report.conformality.quasi_conformal.mean = 1.01;
  return report;
}

std::string objection_to(const CGP::Spin_report& report)
{
  return conformal::objection(report, CGP::Points::Zero(3, 4), {}, "EASIER");
}

void expect_objection(const CGP::Spin_report& report, const std::string& words)
{
  const std::string text = objection_to(report);
  EXPECT_NE(text.find(words), std::string::npos) << text << ", wanted " << words;
}

TEST(Verification, objects_to_nothing_without_a_fault)
{
  EXPECT_EQ(objection_to(faultless()), "");
}

TEST(Verification, objects_to_each_fault_and_to_what_is_no_number)
{
  CGP::Spin_report report = faultless();
  report.steps = 0;
  expect_objection(report, "no part of rho could be reached");
  (report = faultless()).eigenvalue = nan;
  expect_objection(report, "the eigenvalue is not finite");
  (report = faultless()).converged = false;
  expect_objection(report, "the eigenvector did not converge");
  for (const double value : {.2, nan}) {
    (report = faultless()).closure_residual = value;
    expect_objection(report, "the closure residual is");
  }
  for (const double value : {1.6, nan}) {
    (report = faultless()).conformality.quasi_conformal.mean = value;
    expect_objection(report, "the mean quasi-conformal error is");
  }
  (report = faultless()).conformality.flipped_share = .02;
  expect_objection(report, "the share of flipped faces is 0.02");
  (report = faultless()).conformality.quasi_conformal_of_new_area = 2;
  expect_objection(report, "the mean quasi-conformal error over the new area is");
  (report = faultless()).conformality.scale.collapsed_share = .6;
  expect_objection(report, "the share of the area that has collapsed is 0.6");
  (report = faultless()).realised_share = .4;  // .92 of the norm is left out
  expect_objection(report, "only 40 % of the norm of rho is realised");
  (report = faultless()).scales.kept_norm = .05;
  expect_objection(report, "only 5 % of the norm of rho keeps lengths");
  (report = faultless()).residual = 1e-3;  // a tolerance of 1e300 makes everything converge
  expect_objection(report, "the eigenvector did not converge");
  (report = faultless()).direction_error.mean = nan;
  expect_objection(report, "directions at the boundary are missed");
  (report = faultless()).eigenvalue = -2.1;
  report.radius = 1;
  report.limits_gamma = true;
  expect_objection(report, "gamma times the radius is 2.1, more than 2");
  (report = faultless()).boundary_fault = CGP::Spin_report::Boundary_fault::degenerate;
  expect_objection(report, "try: EASIER");
  CGP::Points positions = CGP::Points::Zero(3, 4);
  positions(1, 2) = nan;
  EXPECT_NE(conformal::objection(faultless(), positions, {}, "").find("not finite"),
            std::string::npos);
}

TEST(Verification, tells_what_helps_where_curvature_has_changed_otherwise)
{
  CGP::Spin_report report = faultless();
  EXPECT_EQ(conformal::shortfall(report), "");
  report.realised_curvature = CGP::Realised_curvature{};
  report.realised_curvature->share = .25;
  report.realised_curvature->correlation = .5;
  const auto tells = [&](const std::string& words) {
    return conformal::shortfall(report).find(words) != std::string::npos;
  };
  EXPECT_TRUE(tells("changed by 25 % of rho with a correlation of 0.5"));
  EXPECT_TRUE(tells("a finer mesh"));
  EXPECT_TRUE(tells("--max-scale 2"));
  report.is_relaxed = true;
  EXPECT_FALSE(tells("--max-scale"));
  report.missing_share = .8;
  EXPECT_TRUE(tells("--open-handles"));
  report.scales.bound = 2;
  report.scales.weight = .1;
  EXPECT_TRUE(tells("a larger --max-scale"));
  EXPECT_EQ(objection_to(report), "");  // a fault only where it is against rho
  report.realised_curvature->correlation = -.9;
  EXPECT_TRUE(tells("a correlation of -0.9"));
  EXPECT_NE(objection_to(report), "");
}

}  // namespace cgp_test::verification_tests
