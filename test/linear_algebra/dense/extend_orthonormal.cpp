// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests linear_algebra/dense/extend_orthonormal.h
#include <Conformal_geometry_processing/linear_algebra/dense/block_operators.h>
#include <Conformal_geometry_processing/linear_algebra/dense/extend_orthonormal.h>

#include <gtest/gtest.h>

#include "linear_algebra/hermitian_matrices.h"

namespace cgp_test::extend_orthonormal_tests {

namespace CGP = Conformal_geometry_processing;
using Q = CGP::Quaternion<double>;

TEST(Extend_orthonormal, makes_columns_orthonormal_with_the_same_span)
{
  const int n = 12, k = 4;
  const auto vectors = random_block<Q>(n, k, 1);
  const Eigen::VectorXd weights = Eigen::VectorXd::LinSpaced(n, .5, 3);
  CGP::Block<Q> V;
  for (int j = 0; j < k; ++j)
    ASSERT_TRUE(CGP::extend_orthonormal<double>(V, weights, vectors.col(j)));
  const auto weighted = CGP::block_operator(weights)(V);
  EXPECT_LE(
      (real_form(CGP::gram_matrix(V, weighted)) - Eigen::MatrixXd::Identity(4 * k, 4 * k)).norm(),
      1e-13);
  const auto again = CGP::combination(V, CGP::gram_matrix(weighted, vectors));
  EXPECT_LE((real_columns(again) - real_columns(vectors)).norm(), 1e-12);
}

TEST(Extend_orthonormal, leaves_out_what_is_in_the_span)
{
  const int n = 12;
  const auto vectors = random_block<Q>(n, 2, 1), factors = random_block<Q>(2, 1, 2);
  const Eigen::VectorXd weights = Eigen::VectorXd::Ones(n);
  CGP::Block<Q> V;
  for (int j = 0; j < 2; ++j) CGP::extend_orthonormal<double>(V, weights, vectors.col(j));
  EXPECT_FALSE(
      CGP::extend_orthonormal<double>(V, weights, CGP::combination(vectors, factors).col(0)));
  EXPECT_FALSE(CGP::extend_orthonormal<double>(V, weights, vectors.col(0) * 0.));
  EXPECT_EQ(V.cols(), 2);
}

}  // namespace cgp_test::extend_orthonormal_tests
