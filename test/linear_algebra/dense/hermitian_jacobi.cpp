// Tests linear_algebra/dense/hermitian_jacobi.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/dense/hermitian_jacobi.h>

#include <Eigen/Dense>

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
