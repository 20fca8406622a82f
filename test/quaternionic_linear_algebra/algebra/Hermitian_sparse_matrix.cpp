// Tests algebra/Hermitian_sparse_matrix.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>

#include <gtest/gtest.h>

#include <type_traits>

#include "quaternionic_linear_algebra/hermitian_matrices.h"

namespace cgp_test::hermitian_sparse_matrix_tests {

namespace CGP = Conformal_geometry_processing;
using Q = CGP::Quaternion<double>;

template <class Scalar>
class Hermitian_sparse_matrix : public testing::Test {};

using Scalars = testing::Types<double, Q>;
TYPED_TEST_SUITE(Hermitian_sparse_matrix, Scalars);

TYPED_TEST(Hermitian_sparse_matrix, multiplies_as_the_full_matrix_does)
{
  const auto A = random_hermitian<TypeParam>(random_pattern(12, 1), 2);
  const auto x = random_block<TypeParam>(12, 1, 3);
  const CGP::Block<TypeParam> y = A * x.col(0);
  EXPECT_LE((real_columns(y) - real_form(A) * real_columns(x)).norm(), 1e-13);
}

TYPED_TEST(Hermitian_sparse_matrix, multiplies_some_rows_only)
{
  const auto A = random_hermitian<TypeParam>(random_pattern(12, 1), 2);
  const auto x = random_block<TypeParam>(12, 1, 3);
  const auto before = random_block<TypeParam>(12, 1, 4);
  CGP::Block<TypeParam> y = before;
  A.multiply_rows(3, 7, x.col(0), y.col(0));
  const CGP::Vector<TypeParam> all = A * x.col(0);
  for (int i = 0; i < 12; ++i) EXPECT_EQ(y(i, 0), i < 3 || i >= 7 ? before(i, 0) : all[i]);
}

TYPED_TEST(Hermitian_sparse_matrix, moves_without_copying)
{
  EXPECT_TRUE(std::is_nothrow_move_constructible_v<CGP::Hermitian_sparse_matrix<TypeParam>>);
}

TYPED_TEST(Hermitian_sparse_matrix, sets_some_columns_to_zero)
{
  auto A = random_hermitian<TypeParam>(random_pattern(12, 1), 2);
  const auto before = A;
  A.set_zero(3, 7);
  for (int j = 0; j < 12; ++j)
    for (int i = j; i < 12; ++i)
      EXPECT_EQ(A.coefficient(i, j), j < 3 || j >= 7 ? before.coefficient(i, j) : TypeParam{});
}

TYPED_TEST(Hermitian_sparse_matrix, is_its_own_adjoint)
{
  const auto A = random_hermitian<TypeParam>(random_pattern(12, 4), 5);
  EXPECT_EQ(real_form(A), real_form(A).transpose());
  for (int j = 0; j < 12; ++j)
    EXPECT_EQ(A.coefficient(j, j),
              CGP::internal::Scalar_traits<TypeParam>::from_real(A.diagonal(j)));
}

TYPED_TEST(Hermitian_sparse_matrix, is_zero_outside_of_its_pattern)
{
  const Pattern pattern = random_pattern(12, 4);
  const auto A = random_hermitian<TypeParam>(pattern, 5);
  for (int j = 0; j < 12; ++j)
    for (int i = j; i < 12; ++i) {
      const int k = pattern->find(i, j);
      EXPECT_EQ(A.coefficient(i, j), k < 0 ? TypeParam{} : A.value(k));
    }
}

TYPED_TEST(Hermitian_sparse_matrix, starts_at_zero_and_shares_its_pattern)
{
  const Pattern pattern = random_pattern(5, 6);
  CGP::Hermitian_sparse_matrix<TypeParam> A(pattern);
  EXPECT_EQ(&A.pattern(), pattern.get());
  EXPECT_EQ(A.shared_pattern(), pattern);
  EXPECT_TRUE(real_form(A).isZero(0));
  A.value(2) = CGP::internal::Scalar_traits<TypeParam>::from_real(1);
  A.set_zero();
  EXPECT_TRUE(real_form(A).isZero(0));
}

TEST(Hermitian_sparse_matrix_of_quaternions, is_right_linear)
{
  const auto A = random_hermitian<Q>(random_pattern(12, 7), 8);
  const auto x = random_quaternions(12, 9);
  const Q q{0.5, -1, 2, 0.25};
  CGP::Quaternion_vector<double> xq(12);
  for (int i = 0; i < 12; ++i) xq[i] = x[i] * q;
  const auto left = A * xq, right = A * x;
  for (int i = 0; i < 12; ++i) EXPECT_LE(CGP::norm(left[i] - right[i] * q), 1e-13);
}

TEST(Hermitian_sparse_matrix_of_nothing, has_no_rows)
{
  EXPECT_EQ(CGP::Hermitian_sparse_matrix<double>().size(), 0);
}

}  // namespace cgp_test::hermitian_sparse_matrix_tests
