// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/krylov/Krylov_space.h>

#include <gtest/gtest.h>

#include "quaternionic_linear_algebra/hermitian_matrices.h"
#include "quaternionic_linear_algebra/threads/threads.h"

#include <array>

namespace cgp_test::krylov_space_tests {

namespace CGP = Conformal_geometry_processing;
using Q = CGP::Quaternion<double>;

const int n = 700;  // more rows than are combined in one go

CGP::internal::Row_major_multivector panel(const CGP::Block<Q>& v, int capacity)
{
  CGP::internal::Row_major_multivector p(v.rows(), capacity);
  p.append(v.leftCols(1));
  p.append(v.rightCols(v.cols() - 1));
  return p;
}

/// its columns from `first` on
CGP::Block<Q> columns(const CGP::internal::Row_major_multivector& p, int first)
{
  const int count = static_cast<int>(p.size()) - first;
  CGP::Block<Q> one = CGP::Block<Q>::Constant(count, count, {});
  for (int j = 0; j < count; ++j) one(j, j).w = 1;
  return p.combination(one, first);
}

TEST(Row_major_multivector, holds_the_columns_that_it_was_given)
{
  const auto V = random_block<Q>(n, 3, 1);
  const CGP::internal::Row_major_multivector p = panel(V, 5);
  EXPECT_EQ(p.rows(), n);
  EXPECT_EQ(p.size(), 3);
  EXPECT_EQ(p.capacity(), 5);
  EXPECT_EQ(real_columns(columns(p, 1)), real_columns(CGP::Block<Q>(V.rightCols(2))));
}

TEST(Row_major_multivector, has_the_inner_products_of_its_columns)
{
  const auto V = random_block<Q>(n, 3, 1), W = random_block<Q>(n, 2, 2);
  const CGP::internal::Row_major_multivector p = panel(V, 5);
  const Eigen::MatrixXd expected = real_form(V).transpose() * real_form(W);
  EXPECT_LE((real_form(p.gram(W, CGP::internal::Coefficients::quaternions)) - expected).norm(),
            1e-11);
  const auto G = p.gram(W, CGP::internal::Coefficients::reals);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 2; ++j) {
      EXPECT_NEAR(G(i, j).w, expected(4 * i, 4 * j), 1e-11);
      EXPECT_EQ(G(i, j), (Q{G(i, j).w, 0, 0, 0}));
    }
}

TEST(Row_major_multivector, has_those_of_its_last_columns)
{
  const auto V = random_block<Q>(n, 3, 1), W = random_block<Q>(n, 2, 2);
  const Eigen::MatrixXd expected =
      real_form(CGP::Block<Q>(V.rightCols(2))).transpose() * real_form(W);
  const auto found = panel(V, 5).gram(W, CGP::internal::Coefficients::quaternions, 1);
  EXPECT_LE((real_form(found) - expected).norm(), 1e-11);
}

// Rows that no number of threads divides, in products whose last bits depend on their size.
TEST(Row_major_multivector, has_the_same_bits_for_any_number_of_threads)
{
  const int rows = 12001;
  for (const int count : {1, 3, 5}) {
    const auto V = random_block<Q>(rows, 20, 1), C = random_block<Q>(20, count, 2),
               W = random_block<Q>(rows, count, 3);
    const auto results = [&](int threads) {
      const Threads setting(threads);
      CGP::internal::Row_major_multivector p = panel(V, 20);
      const auto G = p.gram(W, CGP::internal::Coefficients::quaternions);
      const auto VC = p.combination(C);
      p.combine(C);
      return std::array{real_columns(G), real_columns(VC), real_columns(columns(p, 0))};
    };
    const auto expected = results(1);
    for (const int threads : {2, 3, 5}) EXPECT_EQ(results(threads), expected);
  }
}

TEST(Row_major_multivector, combines_its_columns_from_the_right)
{
  const auto V = random_block<Q>(n, 3, 3), C = random_block<Q>(3, 2, 4);
  CGP::internal::Row_major_multivector p = panel(V, 4);
  const Eigen::MatrixXd expected = real_form(V) * real_form(C);
  EXPECT_LE((real_form(p.combination(C)) - expected).norm(), 1e-11);
  p.combine(C);
  EXPECT_EQ(p.size(), 2);
  EXPECT_LE((real_form(columns(p, 0)) - expected).norm(), 1e-11);
}

}  // namespace cgp_test::krylov_space_tests
