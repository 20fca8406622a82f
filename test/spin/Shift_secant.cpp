// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Shift_secant.h
#include <Conformal_geometry_processing/spin/Shift_secant.h>

#include <gtest/gtest.h>

#include <cmath>

namespace cgp_test::shift_secant_tests {

using Conformal_geometry_processing::internal::Shift_secant;

const double zero = 0.3;

double change_at(double shift, double slope)
{
  return slope * (shift - zero);
}

/// the shift after some steps from 0
double after(int steps, double slope)
{
  Shift_secant secant;
  double shift = 0;
  for (int k = 0; k < steps; ++k) shift += secant.step(shift, change_at(shift, slope), 1e-12);
  return shift;
}

TEST(Shift_secant, takes_the_change_itself_as_its_first_step)
{
  EXPECT_NEAR(after(1, -1), zero, 1e-15);
  EXPECT_NEAR(after(1, -.2), .2 * zero, 1e-15);
}

TEST(Shift_secant, finds_the_zero_of_a_line_in_two_steps)
{
  for (const double slope : {-1.8, -1., -.5, -.06}) EXPECT_NEAR(after(2, slope), zero, 1e-12);
}

TEST(Shift_secant, never_takes_a_step_of_more_than_twenty_changes)
{
  for (const double slope : {-.01, .5}) {
    Shift_secant secant;
    double shift = 0;
    for (int k = 0; k < 3; ++k) {
      const double change = change_at(shift, slope), step = secant.step(shift, change, 0);
      EXPECT_LE(std::abs(step), 20.001 * std::abs(change)) << slope << ' ' << k;
      EXPECT_GE(step * change, 0) << "towards the quotient";
      shift += step;
    }
  }
}

TEST(Shift_secant, learns_nothing_from_changes_that_differ_by_less_than_their_error)
{
  Shift_secant secant;
  const double first = secant.step(0, .1, 1e-3);
  EXPECT_EQ(secant.step(first, .0995, 1e-3), .0995);
  EXPECT_NE(secant.step(2 * first, .05, 1e-3), .05);
}

TEST(Shift_secant, tells_whether_changes_become_smaller)
{
  Shift_secant secant;
  EXPECT_TRUE(secant.is_nearer(100));
  secant.step(0, .1, 0);
  EXPECT_TRUE(secant.is_nearer(-.09));
  EXPECT_FALSE(secant.is_nearer(-.11));
}

TEST(Shift_secant, keeps_its_derivative_when_it_begins_again)
{
  const double slope = -.2, root = 3;
  Shift_secant secant;
  double shift = 0;
  for (int k = 0; k < 2; ++k) shift += secant.step(shift, slope * (shift - root), 1e-9);
  secant.restart();
  EXPECT_TRUE(secant.is_nearer(1e6));
  EXPECT_NEAR(secant.step(1, slope * (1 - root), 1e-9), root - 1, 1e-12);
}

}  // namespace cgp_test::shift_secant_tests
