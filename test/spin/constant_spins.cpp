// Tests include/Conformal_geometry_processing/spin/constant_spins.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/constant_spins.h>

#include <gtest/gtest.h>

#include <cmath>

namespace cgp_test::constant_spins_tests {

namespace CGP = Conformal_geometry_processing;
using Q = CGP::Quaternion<double>;
using Plane = CGP::internal::Reduced_basis<double>::Plane;

/// the spins that keep a direction: span(1, direction)
Plane keeping(const Q& direction)
{
  return {Q{1, 0, 0, 0}, direction};
}

TEST(Constant_spins, are_the_real_numbers_where_different_directions_are_kept)
{
  const CGP::internal::Reduced_basis<double> basis(4, {1, 3},
                                                   {keeping({0, 1, 0, 0}), keeping({0, 0, 1, 0})});
  const auto spins = CGP::constant_spins(basis);
  ASSERT_EQ(spins.size(), 1);
  EXPECT_NEAR(std::abs(spins[0].w), 1, 1e-14);
}

TEST(Constant_spins, hold_the_rotations_about_parallel_directions)
{
  const CGP::internal::Reduced_basis<double> basis(4, {1, 3},
                                                   {keeping({0, 0, 0, 1}), keeping({0, 0, 0, -1})});
  const auto spins = CGP::constant_spins(basis);
  ASSERT_EQ(spins.size(), 2);
  for (const Q& q : spins) {
    EXPECT_NEAR(CGP::norm(q), 1, 1e-14);
    EXPECT_NEAR(std::hypot(q.x, q.y), 0, 1e-14);
  }
  EXPECT_NEAR(CGP::dot(spins[0], spins[1]), 0, 1e-14);
}

TEST(Constant_spins, do_not_exist_where_directions_are_turned_differently)
{
  const CGP::internal::Reduced_basis<double> basis(
      2, {0, 1}, {keeping({0, 0, 0, 1}), Plane{Q{0, 1, 0, 0}, Q{0, 0, 1, 0}}});
  EXPECT_EQ(CGP::constant_spins(basis).size(), 0);
  EXPECT_EQ(CGP::constant_spins(CGP::internal::Reduced_basis<double>(3, {}, {})).size(), 4);
}

}  // namespace cgp_test::constant_spins_tests
