// Tests linear_algebra/dense/hermitian_jacobi.h
// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/algebra/quaternion_blocks.h>
#include <Conformal_geometry_processing/linear_algebra/dense/hermitian_jacobi.h>

#include <Eigen/Dense>
#include <Eigen/Eigenvalues>

#include <gtest/gtest.h>

#include "linear_algebra/eigen_decompositions.h"

namespace cgp_test::hermitian_jacobi_tests {

namespace CGP = Conformal_geometry_processing;
using Q = CGP::Quaternion<double>;

// Written out here, not to depend on the products of the library.
CGP::Block<Q> product(const CGP::Block<Q>& a, const CGP::Block<Q>& b)
{
  CGP::Block<Q> c(a.rows(), b.cols());
  for (Eigen::Index i = 0; i < a.rows(); ++i)
    for (Eigen::Index j = 0; j < b.cols(); ++j)
      for (Eigen::Index k = 0; k < a.cols(); ++k) c(i, j) += a(i, k) * b(k, j);
  return c;
}

void expect_decomposes(const CGP::Block<Q>& A, double tolerance)
{
  expect_decomposition(CGP::hermitian_jacobi(A), A, tolerance, 1e-13);
}

TEST(Hermitian_jacobi, diagonalises_random_matrices)
{
  for (int d = 0; d <= 12; ++d) expect_decomposes(random_hermitian_block(d, at(d) + 1), 1e-13);
}

TEST(Hermitian_jacobi, finds_each_eigenvalue_of_the_complex_form_once)
{
  const CGP::Block<Q> A = random_hermitian_block(7, 3);
  Eigen::MatrixXcd C(14, 14);
  for (int j = 0; j < 7; ++j)
    for (int i = 0; i < 7; ++i) C.block<2, 2>(2 * i, 2 * j) = CGP::complex_block(A(i, j));
  const Eigen::VectorXd pairs = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd>(C).eigenvalues();
  const auto e = CGP::hermitian_jacobi(A);
  for (int i = 0; i < 7; ++i) {
    EXPECT_NEAR(e.values[i], pairs[2 * i], 1e-13);
    EXPECT_NEAR(e.values[i], pairs[2 * i + 1], 1e-13);
  }
}

TEST(Hermitian_jacobi, knows_a_two_by_two_matrix)
{
  // [1 q; conj(q) 1] with |q| = 2 has the eigenvalues 1 - 2 and 1 + 2.
  CGP::Block<Q> A(2, 2);
  A(0, 0) = A(1, 1) = Q{1, 0, 0, 0};
  A(0, 1) = Q{1, -1, 1, 1};
  A(1, 0) = CGP::conjugate(A(0, 1));
  const auto e = CGP::hermitian_jacobi(A);
  EXPECT_NEAR(e.values[0], -1, 1e-15);
  EXPECT_NEAR(e.values[1], 3, 1e-15);
}

TEST(Hermitian_jacobi, copes_with_equal_eigenvalues)
{
  // U diag(1, 1, 1, 5, 5, -2) U^H with a unitary U.
  const CGP::Block<Q> U = CGP::hermitian_jacobi(random_hermitian_block(6, 4)).vectors;
  const Eigen::VectorXd values = (Eigen::VectorXd(6) << 1, 1, 1, 5, 5, -2).finished();
  CGP::Block<Q> UD = U, UH(6, 6);
  for (int j = 0; j < 6; ++j)
    for (int i = 0; i < 6; ++i) {
      UD(i, j) *= values[j];
      UH(j, i) = CGP::conjugate(U(i, j));
    }
  const CGP::Block<Q> A = product(UD, UH);
  expect_decomposes(A, 1e-13);
  const Eigen::VectorXd found = CGP::hermitian_jacobi(A).values;
  EXPECT_LE((found - (Eigen::VectorXd(6) << -2, 1, 1, 1, 5, 5).finished()).norm(), 1e-13);
}

TEST(Hermitian_jacobi, leaves_diagonal_matrices_alone)
{
  CGP::Block<Q> A(3, 3);
  A(0, 0).w = 3;
  A(1, 1).w = -1;
  A(2, 2).w = 2;
  const auto e = CGP::hermitian_jacobi(A);
  EXPECT_EQ(e.values, Eigen::Vector3d(-1, 2, 3));
  EXPECT_EQ(e.vectors(1, 0), (Q{1, 0, 0, 0}));
  expect_decomposes(CGP::Block<Q>(4, 4), 0);
}

TEST(Hermitian_jacobi, keeps_small_eigenvalues_beside_large_ones)
{
  CGP::Block<Q> A = random_hermitian_block(5, 6);
  const double scales[] = {1, 1e2, 1e4, 1e6, 1e8};
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j) A(i, j) *= scales[i] * scales[j];
  expect_decomposes(A, 1e-13 * 1e16);
}

TEST(Hermitian_jacobi, works_in_single_and_extended_precision)
{
  const CGP::Block<Q> A = random_hermitian_block(4, 7);
  CGP::Block<CGP::Quaternion<float>> F(4, 4);
  CGP::Block<CGP::Quaternion<long double>> L(4, 4);
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) {
      const Q& q = A(i, j);
      F(i, j) = {float(q.w), float(q.x), float(q.y), float(q.z)};
      L(i, j) = {q.w, q.x, q.y, q.z};
    }
  const Eigen::VectorXd expected = CGP::hermitian_jacobi(A).values;
  EXPECT_LE((CGP::hermitian_jacobi(F).values.cast<double>() - expected).norm(), 1e-5);
  EXPECT_LE((CGP::hermitian_jacobi(L).values.cast<double>() - expected).norm(), 1e-14);
}

}  // namespace cgp_test::hermitian_jacobi_tests
