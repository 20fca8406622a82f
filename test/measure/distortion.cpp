// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/distortion.h>

#include <gtest/gtest.h>

#include "support/random.h"

#include <cmath>

namespace cgp_test::distortion_tests {

namespace CGP = Conformal_geometry_processing;

TEST(Distribution, of_one_value_is_that_value)
{
  const auto d =
      CGP::distribution(Eigen::VectorXd::Constant(1, 7), Eigen::VectorXd::Constant(1, 2));
  EXPECT_EQ(d.mean, 7);
  EXPECT_EQ(d.p99, 7);
  EXPECT_EQ(d.max, 7);
}

TEST(Distribution, weighs_the_mean_and_not_the_maximum)
{
  const auto d = CGP::distribution(Eigen::Vector3d(1, 2, 30), Eigen::Vector3d(3, 6, 1));
  EXPECT_DOUBLE_EQ(d.mean, 4.5);
  EXPECT_EQ(d.p99, 30);
  EXPECT_EQ(d.max, 30);
}

TEST(Distribution, has_99_percent_of_the_weight_at_or_below_p99)
{
  Eigen::VectorXd values(1000);
  for (int i = 0; i < 1000; ++i) values[i] = (i * 7) % 1000 + 1;  // 1..1000 in another order
  const auto d = CGP::distribution(values, Eigen::VectorXd::Ones(1000));
  EXPECT_EQ(d.p99, 990);
  EXPECT_EQ(d.max, 1000);
  EXPECT_DOUBLE_EQ(d.mean, 500.5);
}

TEST(Distribution, counts_weights_and_not_values_for_p99)
{
  // The largest value has 2 percent of the weight, or half a percent.
  EXPECT_EQ(CGP::distribution(Eigen::Vector2d(5, 9), Eigen::Vector2d(98, 2)).p99, 9);
  EXPECT_EQ(CGP::distribution(Eigen::Vector2d(5, 9), Eigen::Vector2d(199, 1)).p99, 5);
}

TEST(Distribution, does_not_depend_on_the_order_or_the_unit_of_the_weights)
{
  const Eigen::VectorXd values = random_numbers(50, 1);
  const Eigen::VectorXd weights = random_numbers(50, 2).array() + 1.5;
  const auto d = CGP::distribution(values, weights);
  const auto e = CGP::distribution(values.reverse(), 1024 * weights.reverse());
  EXPECT_NEAR(d.mean, e.mean, 1e-15);
  EXPECT_EQ(d.p99, e.p99);
  EXPECT_EQ(d.max, e.max);
}

TEST(Distribution, keeps_infinite_values)
{
  const auto d = CGP::distribution(Eigen::Vector2d(1, HUGE_VAL), Eigen::Vector2d(1, 1));
  EXPECT_EQ(d.mean, HUGE_VAL);
  EXPECT_EQ(d.max, HUGE_VAL);
}

TEST(Distribution, of_nothing_is_zero)
{
  const auto d = CGP::distribution(Eigen::VectorXd(), Eigen::VectorXd());
  EXPECT_EQ(d.mean, 0);
  EXPECT_EQ(d.p99, 0);
  EXPECT_EQ(d.max, 0);
}

TEST(Histogram, sorts_the_weights_into_bins)
{
  Eigen::VectorXd values(5), weights(5);
  values << 0, .5, 1, 2.5, 3.9;
  weights << 1, 2, 3, 4, 10;
  EXPECT_LT((CGP::histogram(values, weights, 4, 0, 4) - Eigen::Vector4d(3, 3, 4, 10) / 20).norm(),
            1e-15);
}

TEST(Histogram, counts_what_lies_outside_in_the_first_and_last_bin)
{
  const Eigen::VectorXd share = CGP::histogram(Eigen::Vector4d(-HUGE_VAL, -9, 2, HUGE_VAL),
                                               Eigen::Vector4d(1, 1, 1, 5), 2, 0, 2);
  EXPECT_EQ(share, Eigen::Vector2d(.25, .75));
  const Eigen::VectorXd unknown =
      CGP::histogram(Eigen::VectorXd::Constant(1, NAN), Eigen::VectorXd::Ones(1), 2, 0, 2);
  EXPECT_EQ(unknown, Eigen::Vector2d(1, 0));
}

TEST(Histogram, adds_up_to_one)
{
  const Eigen::VectorXd weights = random_numbers(50, 2).array() + 1.5;
  const Eigen::VectorXd share = CGP::histogram(2 * random_numbers(50, 1), weights, 7, -1, 1);
  EXPECT_NEAR(share.sum(), 1, 1e-15);
  EXPECT_GE(share.minCoeff(), 0);
}

}  // namespace cgp_test::distortion_tests
