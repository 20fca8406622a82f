// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>

#include <gtest/gtest.h>

#include <cmath>
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

Q random_quaternion(std::mt19937& generator)
{
  std::uniform_real_distribution<double> number(-1, 1);
  return {number(generator), number(generator), number(generator), number(generator)};
}

Eigen::Vector4d vector(const Q& q)
{
  return {q.w, q.x, q.y, q.z};
}

TEST(Real_block, is_the_multiplication_from_the_left)
{
  std::mt19937 generator(1);
  for (int n = 0; n < 20; ++n) {
    const Q p = random_quaternion(generator), q = random_quaternion(generator);
    EXPECT_LE((CGP::real_block(p) * vector(q) - vector(p * q)).norm(), 1e-15);
  }
}

TEST(Real_block, turns_products_into_products_and_conjugates_into_transposes)
{
  std::mt19937 generator(2);
  for (int n = 0; n < 20; ++n) {
    const Q p = random_quaternion(generator), q = random_quaternion(generator);
    EXPECT_LE((CGP::real_block(p * q) - CGP::real_block(p) * CGP::real_block(q)).norm(), 1e-14);
    EXPECT_EQ(CGP::real_block(CGP::conjugate(q)), CGP::real_block(q).transpose());
  }
}

TEST(Complex_block, is_the_multiplication_from_the_left)
{
  std::mt19937 generator(3);
  for (int n = 0; n < 20; ++n) {
    const Q p = random_quaternion(generator), q = random_quaternion(generator);
    const Eigen::Vector2cd left = CGP::complex_block(p) * CGP::complex_coordinates(q);
    EXPECT_LE((left - CGP::complex_coordinates(p * q)).norm(), 1e-15);
  }
}

TEST(Complex_block, turns_products_into_products_and_conjugates_into_adjoints)
{
  std::mt19937 generator(4);
  for (int n = 0; n < 20; ++n) {
    const Q p = random_quaternion(generator), q = random_quaternion(generator);
    const Eigen::Matrix2cd product = CGP::complex_block(p) * CGP::complex_block(q);
    EXPECT_LE((CGP::complex_block(p * q) - product).norm(), 1e-14);
    EXPECT_EQ(CGP::complex_block(CGP::conjugate(q)), CGP::complex_block(q).adjoint());
  }
}

TEST(Complex_coordinates, let_complex_numbers_act_from_the_right)
{
  std::mt19937 generator(5);
  const std::complex<double> c(0.3, -1.7);
  const Q as_quaternion{c.real(), c.imag(), 0, 0};
  for (int n = 0; n < 20; ++n) {
    const Q q = random_quaternion(generator);
    EXPECT_LE(
        (CGP::complex_coordinates(q * as_quaternion) - CGP::complex_coordinates(q) * c).norm(),
        1e-15);
  }
}

TEST(Complex_coordinates, can_be_undone)
{
  std::mt19937 generator(6);
  for (int i = 0; i < 5; ++i) {
    const Q q = random_quaternion(generator);
    const Eigen::Vector2cd c = CGP::complex_coordinates(q);
    EXPECT_EQ(CGP::quaternion(c[0], c[1]), q);
  }
}

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

}  // namespace cgp_test::quaternion_vector_tests
