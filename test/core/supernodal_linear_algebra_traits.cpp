// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/core/Supernodal_linear_algebra_traits.h>

#include <gtest/gtest.h>

namespace cgp_test::supernodal_linear_algebra_traits_tests {

using Traits = Conformal_geometry_processing::Supernodal_linear_algebra_traits;

// The Laplacian of a path of n vertices, whose ends are fixed by rows of the identity.
Traits::Matrix path(std::size_t n)
{
  Traits::Matrix A(n, n);
  for (std::size_t i = 0; i < n; ++i) {
    const bool is_fixed = i == 0 || i + 1 == n;
    A.set_coef(i, i, is_fixed ? 1 : 2, true);
    if (is_fixed) continue;
    A.set_coef(i, i - 1, -1, true);
    A.set_coef(i, i + 1, -1, true);
  }
  return A;
}

TEST(Supernodal_linear_algebra_traits, harmonic_between_fixed_values_is_linear)
{
  const std::size_t n = 11;
  Traits::Vector b(n), x(n);
  for (std::size_t i = 0; i < n; ++i) b.set(i, 0);
  b.set(0, 2);
  b.set(n - 1, 7);
  double denominator = 0;
  ASSERT_TRUE(Traits().linear_solver(path(n), b, x, denominator));
  EXPECT_EQ(denominator, 1);
  for (std::size_t i = 0; i < n; ++i)
    EXPECT_NEAR(x[static_cast<int>(i)], 2 + .5 * double(i), 1e-13);
}

TEST(Supernodal_linear_algebra_traits, refuses_what_is_not_positive_definite)
{
  Traits::Matrix A(2, 2);
  A.set_coef(0, 0, 2, true);
  A.set_coef(1, 1, -2, true);
  Traits::Vector b(2), x(2);
  b.set(0, 1), b.set(1, 1), x.set(0, 3), x.set(1, 4);
  double denominator = 0;
  EXPECT_FALSE(Traits().linear_solver(A, b, x, denominator));
  EXPECT_EQ(x[0], 3);
  EXPECT_EQ(x[1], 4);
}

}  // namespace cgp_test::supernodal_linear_algebra_traits_tests
