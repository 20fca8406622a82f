// Tests linear_algebra/dense/quaternionic_householder.h
// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/curves/Closing_functions.h>
#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/linear_algebra/dense/block_products.h>
#include <Conformal_geometry_processing/linear_algebra/dense/quaternionic_householder.h>

#include <gtest/gtest.h>

#include <limits>

#include "linear_algebra/eigen_decompositions.h"

namespace cgp_test::quaternionic_householder_tests {

namespace CGP = Conformal_geometry_processing;
using Q = CGP::Quaternion<double>;

void expect_decomposes(const CGP::Block<Q>& A, double tolerance)
{
  expect_decomposition(CGP::quaternionic_householder(A), A, tolerance, tolerance);
}

TEST(Quaternionic_householder, diagonalises_random_matrices)
{
  for (int d : {1, 2, 3, 4, 7, 20}) expect_decomposes(random_hermitian_block(d, at(d)), 1e-12);
}

TEST(Quaternionic_householder, finds_the_values_of_the_method_of_jacobi)
{
  const CGP::Block<Q> A = random_hermitian_block(15, 3);
  EXPECT_LE((CGP::quaternionic_householder(A).values - CGP::hermitian_jacobi(A).values).norm(),
            1e-13);
}

TEST(Quaternionic_householder, makes_a_real_tridiagonal_matrix)
{
  const CGP::Block<Q> A = random_hermitian_block(9, 5);
  const auto T = CGP::tridiagonalized(A);
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(36, 36);
  const auto set = [&](int i, int j, double x) {
    expected.block<4, 4>(4 * i, 4 * j) = x * Eigen::Matrix4d::Identity();
  };
  for (int i = 0; i < 9; ++i) set(i, i, T.diagonal[i]);
  for (int i = 0; i < 8; ++i) set(i, i + 1, T.subdiagonal[i]), set(i + 1, i, T.subdiagonal[i]);
  EXPECT_LE((real_form(T.Q).transpose() * real_form(A) * real_form(T.Q) - expected).norm(), 1e-13);
  EXPECT_GE(T.subdiagonal.minCoeff(), 0);
}

TEST(Quaternionic_householder, copes_with_equal_eigenvalues_and_zeros)
{
  CGP::Block<Q> U = CGP::hermitian_jacobi(random_hermitian_block(6, 4)).vectors, UD = U;
  const double values[] = {1, 1, 1, 5, 5, -2};
  for (int j = 0; j < 6; ++j) CGP::scale_column(UD, j, values[j]);
  CGP::Block<Q> UH(6, 6);
  for (int j = 0; j < 6; ++j)
    for (int i = 0; i < 6; ++i) UH(j, i) = CGP::conjugate(U(i, j));
  expect_decomposes(CGP::combination(UD, UH), 1e-12);
  expect_decomposes(CGP::Block<Q>::Constant(4, 4, Q{}), 0);
}

TEST(Quaternionic_householder, of_a_real_matrix_is_real)
{
  CGP::Block<Q> A = random_hermitian_block(8, 6);
  for (Eigen::Index k = 0; k < A.size(); ++k) A.data()[k] = Q{A.data()[k].w, 0, 0, 0};
  expect_decomposes(A, 1e-13);
  const CGP::Block<Q> V = CGP::quaternionic_householder(A).vectors;
  for (Eigen::Index k = 0; k < V.size(); ++k) EXPECT_EQ(V.data()[k], (Q{V.data()[k].w, 0, 0, 0}));
}

TEST(Quaternionic_householder, refuses_values_that_are_not_finite)
{
  CGP::Block<Q> A = random_hermitian_block(4, 7);
  A(2, 2).w = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)CGP::quaternionic_householder(A), CGP::Solver_error);
}

}  // namespace cgp_test::quaternionic_householder_tests
