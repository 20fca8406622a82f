// Tests include/Quaternionic_linear_algebra/vector_units/kernel_arithmetic.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

#include <Quaternionic_linear_algebra/vector_units/kernel_arithmetic.h>

#include <gtest/gtest.h>

#include <limits>

namespace cgp_test::plain_functions_tests {

namespace plain = Conformal_geometry_processing::internal;

TEST(Plain_functions, compare)
{
  EXPECT_EQ(plain::least(3, 2), 2);
  EXPECT_EQ(plain::least(2, 3), 2);
  EXPECT_EQ(plain::greatest(3, 2), 3);
  EXPECT_EQ(plain::greatest(2, 3), 3);
}

TEST(Plain_functions, know_good_pivots)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(plain::is_good_pivot(1e-300));
  EXPECT_TRUE(plain::is_good_pivot((std::numeric_limits<double>::max)()));
  for (const double bad : {0., -1., infinity, -infinity, infinity - infinity})
    EXPECT_FALSE(plain::is_good_pivot(bad));
  EXPECT_TRUE(plain::is_good_pivot(1e-38f));
  EXPECT_FALSE(plain::is_good_pivot(1e-39f)) << "its reciprocal overflows";
}

TEST(Plain_functions, take_roots_and_set_zeros)
{
  EXPECT_EQ(plain::square_root(9.), 3.);
  EXPECT_EQ(plain::square_root(9.f), 3.f);
  double numbers[3] = {1, 2, 3};
  plain::set_zero(numbers, 2);
  EXPECT_EQ(numbers[0] + numbers[1], 0);
  EXPECT_EQ(numbers[2], 3);
}

}  // namespace cgp_test::plain_functions_tests
