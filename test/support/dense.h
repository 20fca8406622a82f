// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/operators/calculus.h>
#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>

#include <Eigen/Core>

#include "support/random.h"

/// Small dense matrices of quaternions, by the definitions of matrix algebra.
namespace cgp_test {

using Quaternion_matrix = Conformal_geometry_processing::Block<Quaternion<double>>;

Quaternion_matrix zero_matrix(int rows, int cols);

Quaternion_matrix dense(
    const Conformal_geometry_processing::internal::Quaternionic_sparse_matrix<double>& A);

template <class Scalar>
Conformal_geometry_processing::Block<Scalar> dense(
    const Conformal_geometry_processing::Hermitian_sparse_matrix<Scalar>& A)
{
  Conformal_geometry_processing::Block<Scalar> M(A.size(), A.size());
  for (int i = 0; i < A.size(); ++i)
    for (int j = 0; j < A.size(); ++j) M(i, j) = A.coefficient(i, j);
  return M;
}

/// A^H diag(m) B
Quaternion_matrix adjoint_product(const Quaternion_matrix& A, const Eigen::VectorXd& m,
                                  const Quaternion_matrix& B);

/// the greatest |A_ij|
double greatest_entry(const Quaternion_matrix& A);

/// the greatest |A_ij - B_ij| relative to the greatest |B_ij|
double relative_difference(const Quaternion_matrix& A, const Quaternion_matrix& B);

/// the greatest |A_ij - conjugate(A_ji)| relative to the greatest |A_ij|
double hermitian_defect(const Quaternion_matrix& A);

Eigen::MatrixXd real_part(const Quaternion_matrix& A);

/// the real 4n x 4n matrix of x -> A x; columns are images of the units 1, i, j, k
Eigen::MatrixXd real_form(const Quaternion_matrix& A);

/// the greatest |a_i - b_i|
double greatest_difference(const Quaternion_vector<double>& a, const Quaternion_vector<double>& b);

/// the vectors of R^3 in the columns, as imaginary quaternions
Quaternion_vector<double> imaginary_columns(const Eigen::Matrix3Xd& v);

}  // namespace cgp_test
