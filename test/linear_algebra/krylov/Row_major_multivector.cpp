// Tests linear_algebra/krylov/Row_major_multivector.h
// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/krylov/Row_major_multivector.h>

#include <gtest/gtest.h>

#include "linear_algebra/hermitian_matrices.h"

namespace CGP = Conformal_geometry_processing;
using namespace cgp_test;
using Q = CGP::Quaternion<double>;

namespace {

const int n = 700;  // more rows than are combined in one go

CGP::internal::Row_major_multivector panel(const CGP::Block<Q>& v, int capacity)
{
  CGP::internal::Row_major_multivector p(v.rows(), capacity);
  p.append(v.leftCols(1));
  p.append(v.rightCols(v.cols() - 1));
  return p;
}

}  // namespace

TEST(Row_major_multivector, holds_the_columns_that_it_was_given)
{
  const auto V = random_block<Q>(n, 3, 1);
  const CGP::internal::Row_major_multivector p = panel(V, 5);
  EXPECT_EQ(p.rows(), n);
  EXPECT_EQ(p.size(), 3);
  EXPECT_EQ(p.capacity(), 5);
  EXPECT_EQ(real_columns(p.columns(1, 2)), real_columns(CGP::Block<Q>(V.rightCols(2))));
}

TEST(Row_major_multivector, has_the_inner_products_of_its_columns)
{
  const auto V = random_block<Q>(n, 3, 1), W = random_block<Q>(n, 2, 2);
  const CGP::internal::Row_major_multivector p = panel(V, 5);
  const Eigen::MatrixXd expected = dense(V).transpose() * dense(W);
  EXPECT_LE((dense(p.gram(W, CGP::internal::Coefficients::quaternions)) - expected).norm(), 1e-11);
  const auto G = p.gram(W, CGP::internal::Coefficients::reals);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 2; ++j) {
      EXPECT_NEAR(G(i, j).w, expected(4 * i, 4 * j), 1e-11);
      EXPECT_EQ(G(i, j), (Q{G(i, j).w, 0, 0, 0}));
    }
}

TEST(Row_major_multivector, combines_its_columns_from_the_right)
{
  const auto V = random_block<Q>(n, 3, 3), C = random_block<Q>(3, 2, 4);
  CGP::internal::Row_major_multivector p = panel(V, 4);
  const Eigen::MatrixXd expected = dense(V) * dense(C);
  EXPECT_LE((dense(p.combination(C)) - expected).norm(), 1e-11);
  p.combine(C);
  EXPECT_EQ(p.size(), 2);
  EXPECT_LE((dense(p.columns(0, 2)) - expected).norm(), 1e-11);
}
