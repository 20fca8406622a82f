// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/algebra/random_quaternions.h
#include <Conformal_geometry_processing/algebra/random_quaternions.h>

#include <gtest/gtest.h>

#include <cmath>

namespace cgp_test::random_quaternions_tests {

namespace CGP = Conformal_geometry_processing;

TEST(Random_quaternions, are_the_same_for_the_same_seed_only)
{
  const auto x = CGP::random_quaternions(50, 2, 7);
  ASSERT_EQ(x.rows(), 50);
  ASSERT_EQ(x.cols(), 2);
  EXPECT_TRUE(x == CGP::random_quaternions(50, 2, 7));
  EXPECT_FALSE(x == CGP::random_quaternions(50, 2, 8));
}

TEST(Random_quaternions, have_independent_components_uniform_around_zero)
{
  const auto x = CGP::random_quaternions(10000, 2, 3);
  Eigen::MatrixXd c(x.size(), 4);
  for (Eigen::Index i = 0; i < x.size(); ++i)
    c.row(i) << x.data()[i].w, x.data()[i].x, x.data()[i].y, x.data()[i].z;
  EXPECT_GE(c.minCoeff(), -.5);
  EXPECT_LT(c.maxCoeff(), .5);
  // Five standard deviations: 1/12 is the variance of a component.
  const double n = static_cast<double>(x.size()), deviation = 5 / std::sqrt(12 * n);
  EXPECT_LT(c.colwise().mean().cwiseAbs().maxCoeff(), deviation);
  const Eigen::Matrix4d covariance = c.transpose() * c / n;
  EXPECT_LT((covariance - Eigen::Matrix4d::Identity() / 12).cwiseAbs().maxCoeff(), deviation);
}

}  // namespace cgp_test::random_quaternions_tests
