// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Period_limit.h
#include <Conformal_geometry_processing/spin/Period_limit.h>

#include <gtest/gtest.h>

namespace cgp_test::period_limit_tests {

using Conformal_geometry_processing::Spin_report;
using Conformal_geometry_processing::internal::Period_limit;

Spin_report distorted_by(double distortion)
{
  Spin_report report;
  report.conformality.quasi_conformal.mean = 1 + distortion;
  return report;
}

TEST(Period_limit, is_what_is_given)
{
  for (const double distortion : {0., .04, 3.})
    EXPECT_EQ((Period_limit{.004, 1e-8}(distorted_by(distortion))), .004);
}

TEST(Period_limit, falls_with_the_discretisation_error_otherwise)
{
  const Period_limit limit{{}, 1e-8};
  for (const double distortion : {.06, .04, .02}) {
    EXPECT_LE(limit(distorted_by(distortion)), .25 * distortion * (1 + 1e-9));
    EXPECT_NEAR(limit(distorted_by(distortion)) / limit(distorted_by(distortion / 2)), 2, 1e-9);
  }
}

TEST(Period_limit, is_neither_below_two_per_mille_nor_above_two_per_cent)
{
  const Period_limit limit{{}, 1e-8};
  EXPECT_EQ(limit(distorted_by(0)), .002);
  EXPECT_EQ((Period_limit{{}, .003}(distorted_by(0))), .003);
  EXPECT_EQ(limit(distorted_by(3)), .02);
}

}  // namespace cgp_test::period_limit_tests
