// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/flow/step_fault.h
#include <Conformal_geometry_processing/flow/step_fault.h>

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace cgp_test::step_fault_tests {

namespace CGP = Conformal_geometry_processing;
using Boundary_fault = CGP::Spin_report::Boundary_fault;

class A_step : public testing::Test {
 protected:
  bool is_good() const { return CGP::step_fault(report, is_turning, is_exact, options).empty(); }

  CGP::Flow_options options;
  bool is_turning = false, is_exact = false;
  CGP::Spin_report report = [] {
    CGP::Spin_report good;
    good.converged = true;
    good.conformality.quasi_conformal.mean = 1;
    return good;
  }();
};

TEST_F(A_step, whose_equation_is_solved_may_be_taken)
{
  EXPECT_TRUE(is_good());
  report.converged = false;
  EXPECT_EQ(CGP::step_fault(report, false, false, options), "the Dirac equation is not solved");
  options.backtracking = false;
  EXPECT_FALSE(is_good());
}

TEST_F(A_step, that_distorts_is_not_taken_where_a_smaller_one_can_be)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {1.5, nan}) {
    report.conformality.quasi_conformal.mean = bad;
    options.backtracking = true;
    EXPECT_NE(CGP::step_fault(report, false, false, options).find("quasi-conformal"),
              std::string::npos);
    options.backtracking = false;
    EXPECT_TRUE(is_good());
  }
}

TEST_F(A_step, from_which_the_exact_class_is_to_be_reached_distorts_little)
{
  report.conformality.quasi_conformal.mean = 1.3;
  EXPECT_TRUE(is_good());
  is_exact = true;
  EXPECT_FALSE(is_good());
  options.max_step_distortion = 1.4;
  EXPECT_TRUE(is_good());
}

TEST_F(A_step, that_tears_is_not_taken_where_a_smaller_one_can_be)
{
  report.closure_residual = .9 * options.max_step_closure;
  EXPECT_TRUE(is_good());
  report.closure_residual = options.max_step_closure;
  EXPECT_NE(CGP::step_fault(report, false, false, options).find("closure"), std::string::npos);
  options.backtracking = false;
  EXPECT_TRUE(is_good());
}

TEST_F(A_step, to_directions_that_no_surface_has_is_not_taken_but_keeping_directions_is)
{
  report.boundary_fault = Boundary_fault::not_realizable;
  EXPECT_TRUE(is_good());
  is_turning = true;
  EXPECT_EQ(CGP::step_fault(report, true, false, options),
            CGP::to_string(Boundary_fault::not_realizable));
}

}  // namespace cgp_test::step_fault_tests
