// Tests algebra/quaternion_blocks.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/algebra/quaternion_blocks.h>

#include <gtest/gtest.h>

#include <random>

namespace cgp_test::quaternion_blocks_tests {

namespace CGP = Conformal_geometry_processing;
using Q = CGP::Quaternion<double>;

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
  CGP::Quaternion_vector<double> v(5);
  for (Q& q : v) q = random_quaternion(generator);
  const auto c = CGP::to_complex(v);
  ASSERT_EQ(c.size(), 10);
  const auto w = CGP::from_complex(c);
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(w[i], v[i]);
    EXPECT_EQ(CGP::quaternion(c[2 * i], c[2 * i + 1]), v[i]);
  }
}

}  // namespace cgp_test::quaternion_blocks_tests
