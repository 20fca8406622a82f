// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef TEST_LINEAR_ALGEBRA_EIGEN_DECOMPOSITIONS_H
#define TEST_LINEAR_ALGEBRA_EIGEN_DECOMPOSITIONS_H

#include <gtest/gtest.h>

#include <cstdint>

#include "linear_algebra/hermitian_matrices.h"

namespace cgp_test {

/// a dense Hermitian matrix of quaternions
inline CGP::Block<Quaternion<double>> random_hermitian_block(int d, std::uint64_t seed)
{
  CGP::Block<Quaternion<double>> A = random_block<Quaternion<double>>(d, d, seed);
  for (int j = 0; j < d; ++j) {
    A(j, j) = {A(j, j).w, 0, 0, 0};
    for (int i = 0; i < j; ++i) A(j, i) = CGP::conjugate(A(i, j));
  }
  return A;
}

/// A V = V D with orthonormal V and ascending D
template <class Decomposition>
void expect_decomposition(const Decomposition& e, const CGP::Block<Quaternion<double>>& A,
                          double tolerance, double tolerance_of_vectors)
{
  const int d = static_cast<int>(A.rows());
  ASSERT_EQ(e.values.size(), d);
  const Eigen::MatrixXd V = real_form(e.vectors), D = four_times(e.values).asDiagonal();
  EXPECT_LE((real_form(A) * V - V * D).norm(), tolerance);
  EXPECT_LE((V.transpose() * V - Eigen::MatrixXd::Identity(4 * d, 4 * d)).norm(),
            tolerance_of_vectors);
  for (int i = 1; i < d; ++i) EXPECT_LE(e.values[i - 1], e.values[i]);
}

}  // namespace cgp_test

#endif
