// Tests operators/calculus.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/calculus.h>

#include <gtest/gtest.h>

#include <random>

namespace cgp_test::quaternionic_sparse_matrix_tests {

namespace CGP = Conformal_geometry_processing;
using Q = CGP::Quaternion<double>;
using Matrix = CGP::internal::Quaternionic_sparse_matrix<double>;

const Matrix::Corners corners = {{0, 1, 2}, {2, 1, 3}, {3, 4, 0}, {4, 2, 0}};

class Quaternionic_sparse_matrix : public testing::Test {
 protected:
  Q random_quaternion()
  {
    return {m_number(m_generator), m_number(m_generator), m_number(m_generator),
            m_number(m_generator)};
  }
  CGP::Quaternion_vector<double> random_vector(int n)
  {
    CGP::Quaternion_vector<double> v(n);
    for (Q& q : v) q = random_quaternion();
    return v;
  }
  Matrix random_matrix()
  {
    Matrix a(corners, 5);
    for (int f = 0; f < a.rows(); ++f)
      for (int c = 0; c < 3; ++c) a.value(f, c) = random_quaternion();
    return a;
  }

 private:
  std::mt19937 m_generator{11};
  std::uniform_real_distribution<double> m_number{-1, 1};
};

TEST_F(Quaternionic_sparse_matrix, multiplies_the_values_of_a_row_by_those_at_its_corners)
{
  const Matrix a = random_matrix();
  const auto x = random_vector(5);
  ASSERT_EQ(a.rows(), 4);
  ASSERT_EQ(a.cols(), 5);
  EXPECT_EQ(a.column(1, 0), 2);
  const auto y = a * x;
  const Q expected = a.value(1, 0) * x[2] + a.value(1, 1) * x[1] + a.value(1, 2) * x[3];
  EXPECT_LE(CGP::norm(y[1] - expected), 1e-15);
}

TEST_F(Quaternionic_sparse_matrix, has_the_adjoint)
{
  const Matrix a = random_matrix();
  const auto x = random_vector(5), y = random_vector(4);
  const Q difference = CGP::inner_product(y, a * x) - CGP::inner_product(a.adjoint_times(y), x);
  EXPECT_LE(CGP::norm(difference), 1e-14);
}

TEST_F(Quaternionic_sparse_matrix, is_right_linear)
{
  const Matrix a = random_matrix();
  const auto x = random_vector(5);
  const Q q = random_quaternion();
  CGP::Quaternion_vector<double> xq(5);
  for (int i = 0; i < 5; ++i) xq[i] = x[i] * q;
  const auto left = a * xq, right = a * x;
  for (int f = 0; f < 4; ++f) EXPECT_LE(CGP::norm(left[f] - right[f] * q), 1e-14);
}

TEST_F(Quaternionic_sparse_matrix, subtracts_value_by_value)
{
  const Matrix a = random_matrix(), b = random_matrix();
  const Matrix c = a - b;
  for (int f = 0; f < 4; ++f)
    for (int k = 0; k < 3; ++k) EXPECT_EQ(c.value(f, k), a.value(f, k) - b.value(f, k));
}

TEST_F(Quaternionic_sparse_matrix, starts_at_zero)
{
  const Matrix a(corners, 5);
  for (int f = 0; f < 4; ++f)
    for (int c = 0; c < 3; ++c) EXPECT_EQ(a.value(f, c), Q{});
}

}  // namespace cgp_test::quaternionic_sparse_matrix_tests
