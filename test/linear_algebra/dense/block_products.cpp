// Tests linear_algebra/dense/block_products.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/dense/block_products.h>

#include <gtest/gtest.h>

#include "linear_algebra/hermitian_matrices.h"

namespace cgp_test::block_products_tests {

namespace CGP = Conformal_geometry_processing;
using Q = CGP::Quaternion<double>;

TEST(Gram_matrix, is_the_conjugate_transpose_times_the_other)
{
  const auto A = random_block<Q>(9, 2, 1), B = random_block<Q>(9, 3, 2);
  EXPECT_LE((real_form(CGP::gram_matrix(A, B)) - real_form(A).transpose() * real_form(B)).norm(),
            1e-14);
}

TEST(Combination, multiplies_from_the_right)
{
  const auto V = random_block<Q>(9, 3, 3), C = random_block<Q>(3, 2, 4);
  EXPECT_LE((real_form(CGP::combination(V, C)) - real_form(V) * real_form(C)).norm(), 1e-14);
}

TEST(Replace_by_combination, combines_more_rows_than_it_takes_at_a_time)
{
  const int n = 700;
  for (int columns = 0; columns <= 3; ++columns) {
    const auto W = random_block<Q>(n, columns, 5), V = random_block<Q>(n, 2, 6),
               C = random_block<Q>(columns, 2, 7), D = random_block<Q>(2, 2, 8);
    const CGP::Block<Q> expected = CGP::combination(W, C) + CGP::combination(V, D);
    auto result = W;
    CGP::replace_by_combination(result, C, V, D);
    EXPECT_LE((real_columns(result) - real_columns(expected)).norm(), 1e-12);
  }
}

TEST(Scale_column, scales_just_that_one)
{
  const auto V = random_block<Q>(4, 2, 5);
  auto W = V;
  CGP::scale_column(W, 1, 2.0);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(W(i, 0), V(i, 0));
    EXPECT_EQ(W(i, 1), V(i, 1) + V(i, 1));
  }
}

TEST(Reduced_to, keeps_quaternions_or_their_real_part)
{
  const Q q{1, 2, 3, 4};
  EXPECT_EQ(CGP::reduced_to(CGP::internal::Coefficients::quaternions, q), q);
  EXPECT_EQ(CGP::reduced_to(CGP::internal::Coefficients::reals, q), (Q{1, 0, 0, 0}));
}

TEST(Gram_matrix, over_the_reals_holds_the_inner_products_of_the_components)
{
  const auto A = random_block<Q>(9, 2, 1), B = random_block<Q>(9, 3, 2);
  const auto G = CGP::gram_matrix(A, B, CGP::internal::Coefficients::reals);
  const Eigen::MatrixXd expected = real_columns(A).transpose() * real_columns(B);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 3; ++j) {
      EXPECT_NEAR(G(i, j).w, expected(i, j), 1e-14);
      EXPECT_EQ(G(i, j), (Q{G(i, j).w, 0, 0, 0}));
    }
}

}  // namespace cgp_test::block_products_tests
