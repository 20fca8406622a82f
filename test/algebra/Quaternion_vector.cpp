// Tests algebra/Quaternion_vector.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/algebra/Quaternion_vector.h>

#include <gtest/gtest.h>

#include <random>

namespace cgp_test::quaternion_vector_tests {

namespace CGP = Conformal_geometry_processing;
using Q = CGP::Quaternion<double>;
using V = CGP::Quaternion_vector<double>;

V random_vector(int n, unsigned seed)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  V v(n);
  for (Q& q : v) q = {number(generator), number(generator), number(generator), number(generator)};
  return v;
}

TEST(Quaternion_vector, starts_at_zero)
{
  const V v(3);
  for (const Q& q : v) EXPECT_EQ(q, Q{});
}

TEST(Quaternion_vector, adds_and_scales_like_any_eigen_vector)
{
  const V a = random_vector(4, 1), b = random_vector(4, 2);
  const V c = 2.0 * a - b * 3.0;
  for (int i = 0; i < 4; ++i) EXPECT_LE(CGP::norm(c[i] - (a[i] + a[i] - 3.0 * b[i])), 1e-15);
}

TEST(Components, are_columns_of_w_x_y_z_over_the_same_memory)
{
  V v(2);
  v[1] = {1, 2, 3, 4};
  EXPECT_EQ(CGP::components(std::as_const(v)).col(1), Eigen::Vector4d(1, 2, 3, 4));
  CGP::components(v)(2, 0) = 7;
  EXPECT_EQ(v[0], (Q{0, 0, 7, 0}));
}

TEST(Inner_product, is_right_linear_and_hermitian)
{
  const V a = random_vector(6, 3), b = random_vector(6, 4);
  const CGP::Vector<double> m = CGP::Vector<double>::LinSpaced(6, 1, 2);
  const Q q{0.3, -1, 2, 0.5};
  V bq(6);
  for (int i = 0; i < 6; ++i) bq[i] = b[i] * q;
  EXPECT_LE(CGP::norm(CGP::inner_product(a, m, bq) - CGP::inner_product(a, m, b) * q), 1e-14);
  EXPECT_LE(CGP::norm(CGP::inner_product(b, m, a) - CGP::conjugate(CGP::inner_product(a, m, b))),
            1e-14);
  EXPECT_LE(CGP::norm(CGP::inner_product(a, bq) - CGP::inner_product(a, b) * q), 1e-14);
}

TEST(Inner_product, weighs_squared_norms_by_the_masses)
{
  V a(2);
  a[0] = {1, -2, 4, 10};
  a[1] = {0, 3, 4, 0};
  const CGP::Vector<double> m = Eigen::Vector2d(2, 10);
  EXPECT_EQ(CGP::inner_product(a, m, a), (Q{492, 0, 0, 0}));
  EXPECT_EQ(CGP::inner_product(a, a), (Q{146, 0, 0, 0}));
}

}  // namespace cgp_test::quaternion_vector_tests
