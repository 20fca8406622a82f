// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>
#include <Quaternionic_linear_algebra/dense/hermitian_eigen_decomposition.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <gtest/gtest.h>
#include <Eigen/Dense>
#include <Eigen/Eigenvalues>

#include "quaternionic_linear_algebra/eigen_decompositions.h"

#include <complex>
#include <limits>

namespace cgp_test::hermitian_eigen_decomposition_tests {

namespace CGP = Conformal_geometry_processing;
using Q = CGP::Quaternion<double>;

// Written out here, not to depend on the products of the library.
template <class Scalar>
CGP::Block<Scalar> product(const CGP::Block<Scalar>& a, const CGP::Block<Scalar>& b)
{
  CGP::Block<Scalar> c = CGP::Block<Scalar>::Constant(a.rows(), b.cols(), Scalar{});
  for (Eigen::Index i = 0; i < a.rows(); ++i)
    for (Eigen::Index j = 0; j < b.cols(); ++j)
      for (Eigen::Index k = 0; k < a.cols(); ++k) c(i, j) += a(i, k) * b(k, j);
  return c;
}

template <class Scalar>
void expect_decomposes(const CGP::Block<Scalar>& A, double tolerance)
{
  expect_decomposition(CGP::hermitian_eigen_decomposition(A), A, tolerance, 1e-13);
}

/// U diag(values) U^H with a unitary U
template <class Scalar>
CGP::Block<Scalar> with_eigenvalues(const Eigen::VectorXd& values, std::uint64_t seed)
{
  const int d = static_cast<int>(values.size());
  const CGP::Block<Scalar> U =
      CGP::hermitian_eigen_decomposition(random_hermitian_block<Scalar>(d, seed)).vectors;
  CGP::Block<Scalar> UD = U, UH = U;
  for (int j = 0; j < d; ++j)
    for (int i = 0; i < d; ++i) {
      UD(i, j) *= values[j];
      UH(j, i) = CGP::conjugate(U(i, j));
    }
  return product(UD, UH);
}

template <class Scalar>
class Hermitian_eigen_decomposition : public testing::Test {};

using Scalars = testing::Types<double, std::complex<double>, Q>;
TYPED_TEST_SUITE(Hermitian_eigen_decomposition, Scalars);

TYPED_TEST(Hermitian_eigen_decomposition, diagonalises_random_matrices)
{
  for (int d = 0; d <= 12; ++d)
    expect_decomposes(random_hermitian_block<TypeParam>(d, at(d) + 1), 1e-13);
  expect_decomposes(random_hermitian_block<TypeParam>(40, 1), 1e-12);
}

TYPED_TEST(Hermitian_eigen_decomposition, copes_with_equal_eigenvalues)
{
  const Eigen::VectorXd values = (Eigen::VectorXd(6) << 1, 1, 1, 5, 5, -2).finished();
  const auto A = with_eigenvalues<TypeParam>(values, 4);
  expect_decomposes(A, 1e-13);
  const Eigen::VectorXd found = CGP::hermitian_eigen_decomposition(A).values;
  EXPECT_LE((found - (Eigen::VectorXd(6) << -2, 1, 1, 1, 5, 5).finished()).norm(), 1e-13);
}

TYPED_TEST(Hermitian_eigen_decomposition, copes_with_clusters)
{
  for (const double gap : {1e-4, 1e-8, 1e-12, 1e-15}) {
    const Eigen::VectorXd values =
        (Eigen::VectorXd(8) << 1, 1 + gap, 1 + 2 * gap, 1 + 3 * gap, 2, 2 + gap, -1, -1 - gap)
            .finished();
    expect_decomposes(with_eigenvalues<TypeParam>(values, 5), 1e-13);
  }
}

TYPED_TEST(Hermitian_eigen_decomposition, of_zero_and_of_the_identity)
{
  for (int d : {1, 2, 3, 7}) {
    CGP::Block<TypeParam> A = CGP::Block<TypeParam>::Constant(d, d, TypeParam{});
    expect_decomposes(A, 0);
    for (int i = 0; i < d; ++i) A(i, i) = CGP::internal::Scalar_traits<TypeParam>::from_real(1);
    expect_decomposes(A, 0);
  }
}

TYPED_TEST(Hermitian_eigen_decomposition, is_that_of_the_scaled_matrix_in_any_unit)
{
  const auto A = random_hermitian_block<TypeParam>(6, 9);
  const auto e = CGP::hermitian_eigen_decomposition(A);
  for (const double unit : {0x1p-1000, 0x1p-500, 0x1p500, 0x1p1000}) {
    CGP::Block<TypeParam> scaled = A;
    for (Eigen::Index k = 0; k < A.size(); ++k) scaled.data()[k] *= unit;
    const auto s = CGP::hermitian_eigen_decomposition(scaled);
    EXPECT_EQ(s.values / unit, e.values);
    EXPECT_TRUE(s.vectors == e.vectors);
  }
}

TYPED_TEST(Hermitian_eigen_decomposition, of_graded_matrices_has_errors_of_their_norm)
{
  auto A = random_hermitian_block<TypeParam>(5, 6);
  const double scales[] = {1, 1e2, 1e4, 1e6, 1e8};
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j) A(i, j) *= scales[i] * scales[j];
  expect_decomposes(A, 1e-13 * 1e16);
}

TYPED_TEST(Hermitian_eigen_decomposition, refuses_values_that_are_not_finite)
{
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    auto A = random_hermitian_block<TypeParam>(4, 7);
    A(2, 2) = CGP::internal::Scalar_traits<TypeParam>::from_real(bad);
    EXPECT_THROW((void)CGP::hermitian_eigen_decomposition(A), CGP::Solver_error);
  }
}

TEST(Hermitian_eigen_decomposition_of_quaternions, has_each_value_of_the_complex_form_once)
{
  const CGP::Block<Q> A = random_hermitian_block(7, 3);
  Eigen::MatrixXcd C(14, 14);
  for (int j = 0; j < 7; ++j)
    for (int i = 0; i < 7; ++i) C.block<2, 2>(2 * i, 2 * j) = CGP::complex_block(A(i, j));
  const Eigen::VectorXd pairs = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd>(C).eigenvalues();
  const auto e = CGP::hermitian_eigen_decomposition(A);
  for (int i = 0; i < 7; ++i) {
    EXPECT_NEAR(e.values[i], pairs[2 * i], 1e-13);
    EXPECT_NEAR(e.values[i], pairs[2 * i + 1], 1e-13);
  }
}

TEST(Hermitian_eigen_decomposition_of_quaternions, knows_a_two_by_two_matrix)
{
  // [1 q; conj(q) 1] with |q| = 2 has the eigenvalues 1 - 2 and 1 + 2.
  CGP::Block<Q> A(2, 2);
  A(0, 0) = A(1, 1) = Q{1, 0, 0, 0};
  A(0, 1) = Q{1, -1, 1, 1};
  A(1, 0) = CGP::conjugate(A(0, 1));
  const auto e = CGP::hermitian_eigen_decomposition(A);
  EXPECT_NEAR(e.values[0], -1, 1e-15);
  EXPECT_NEAR(e.values[1], 3, 1e-15);
}

TEST(Hermitian_eigen_decomposition_of_quaternions, leaves_diagonal_matrices_alone)
{
  CGP::Block<Q> A(3, 3);
  A(0, 0).w = 3;
  A(1, 1).w = -1;
  A(2, 2).w = 2;
  const auto e = CGP::hermitian_eigen_decomposition(A);
  EXPECT_EQ(e.values, Eigen::Vector3d(-1, 2, 3));
  EXPECT_EQ(e.vectors(1, 0), (Q{1, 0, 0, 0}));
}

TEST(Hermitian_eigen_decomposition_of_quaternions, is_real_if_the_matrix_is)
{
  CGP::Block<Q> A = random_hermitian_block(8, 6);
  for (Eigen::Index k = 0; k < A.size(); ++k) A.data()[k] = Q{A.data()[k].w, 0, 0, 0};
  expect_decomposes(A, 1e-13);
  const CGP::Block<Q> V = CGP::hermitian_eigen_decomposition(A).vectors;
  for (Eigen::Index k = 0; k < V.size(); ++k) EXPECT_EQ(V.data()[k], (Q{V.data()[k].w, 0, 0, 0}));
}

TEST(Hermitian_eigen_decomposition_of_quaternions, goes_over_a_real_tridiagonal_matrix)
{
  const CGP::Block<Q> A = random_hermitian_block(9, 5);
  const auto T = CGP::internal::tridiagonalized(A);
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(36, 36);
  const auto set = [&](int i, int j, double x) {
    expected.block<4, 4>(4 * i, 4 * j) = x * Eigen::Matrix4d::Identity();
  };
  for (int i = 0; i < 9; ++i) set(i, i, T.diagonal[i]);
  for (int i = 0; i < 8; ++i) set(i, i + 1, T.subdiagonal[i]), set(i + 1, i, T.subdiagonal[i]);
  EXPECT_LE((real_form(T.Q).transpose() * real_form(A) * real_form(T.Q) - expected).norm(), 1e-13);
  EXPECT_GE(T.subdiagonal.minCoeff(), 0);
}

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

}  // namespace cgp_test::hermitian_eigen_decomposition_tests
