// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/best_turn.h
#include <Conformal_geometry_processing/spin/best_turn.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "support/random.h"

namespace cgp_test::best_turn_tests {

namespace CGP = Conformal_geometry_processing;
using Q = Quaternion<double>;

Points random_directions(int n, std::uint64_t seed)
{
  Random random(seed);
  Points U(3, n);
  for (int k = 0; k < n; ++k) U.col(k) = random.vector().normalized();
  return U;
}

double misfit(const Q& q, const Points& U, const Points& V)
{
  double sum = 0;
  for (Eigen::Index k = 0; k < U.cols(); ++k)
    sum += squared_norm(CGP::imaginary(U.col(k)) * q - q * CGP::imaginary(V.col(k)));
  return sum;
}

TEST(Best_turn, is_the_rotation_if_there_is_one)
{
  Random random(1);
  for (int i = 0; i < 20; ++i) {
    const Points U = random_directions(3 + i, 2);
    const Eigen::Matrix3d R = random.rotation();
    const Q q = CGP::best_turn(U, R * U);
    EXPECT_NEAR(norm(q), 1, 1e-14);
    for (int c = 0; c < 3; ++c)
      EXPECT_LT((CGP::spin(q, Eigen::Vector3d::Unit(c)) - R.col(c)).norm(), 1e-12);
  }
}

TEST(Best_turn, is_a_half_turn_if_need_be)
{
  const Points U = random_directions(9, 3);
  const Eigen::Vector3d half_turn(-1, -1, 1);
  const Q q = CGP::best_turn(U, half_turn.asDiagonal() * U);
  EXPECT_NEAR(std::abs(q.z), 1, 1e-13);
}

TEST(Best_turn, fits_no_worse_than_any_other)
{
  const Points U = random_directions(30, 4);
  const Points V =
      (Random(5).rotation() * U + .3 * random_directions(30, 6)).colwise().normalized();
  const Q q = CGP::best_turn(U, V);
  Random random(7);
  for (int i = 0; i < 100; ++i) {
    Q other = q + .1 * random.quaternion();
    other = other / norm(other);
    EXPECT_GE(misfit(other, U, V), misfit(q, U, V));
  }
}

TEST(Best_turn, is_no_half_turn_where_that_fits_little_better)
{
  // Directions nearly on a line, to be tilted beyond it: after a half turn, by a little less.
  Points U(3, 12), V(3, 12);
  for (int k = 0; k < 12; ++k) {
    const double t = 2 * pi * k / 12;
    const Eigen::Vector3d outward(std::cos(t), std::sin(t), 0), up(0, 0, 1);
    U.col(k) = (.1 * outward - up).normalized();
    V.col(k) = (-.5 * outward - std::sqrt(.75) * up).normalized();
  }
  EXPECT_LT(norm(CGP::best_turn(U, V) - Q{1, 0, 0, 0}), 1e-12);
}

TEST(Best_turn, is_none_where_a_half_turn_fits_exactly_and_none_nearly)
{
  Points U(3, 12);
  for (int k = 0; k < 12; ++k) {
    const double t = 2 * pi * k / 12;
    U.col(k) = Eigen::Vector3d(.05 * std::cos(t), .05 * std::sin(t), 1).normalized();
  }
  const Points V = Eigen::Vector3d(-1, -1, 1).asDiagonal() * U;
  EXPECT_LT(norm(CGP::best_turn(U, V) - Q{1, 0, 0, 0}), 1e-12);
}

TEST(Best_turn, is_the_smallest_of_many_where_all_directions_lie_on_a_line)
{
  const Points U = Eigen::Vector3d(0, 0, 1).replicate(1, 8),
               V = Eigen::Vector3d(1, 0, 0).replicate(1, 8);
  const Q expected{std::sqrt(.5), 0, -std::sqrt(.5), 0};  // a right angle about y
  EXPECT_LT(norm(CGP::best_turn(U, V) - expected), 1e-14);
  EXPECT_LT(norm(CGP::best_turn(U, U) - Q{1, 0, 0, 0}), 1e-14);
  EXPECT_LT(misfit(CGP::best_turn(U, -U), U, -U), 1e-25);
}

}  // namespace cgp_test::best_turn_tests
