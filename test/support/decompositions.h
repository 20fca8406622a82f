// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

/// Dense decompositions of real matrices. They are compiled once: each of Eigen's costs several
/// seconds wherever it is used.
namespace cgp_test {

/// ascending; each column of the vectors belongs to one value
struct Eigenpairs {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};

/// A x = x theta for symmetric A, with orthonormal vectors
Eigenpairs symmetric_eigenpairs(const Eigen::MatrixXd& A);
Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& A);

/// A x = N x theta for symmetric A and positive definite N, in which the vectors are orthonormal
Eigenpairs symmetric_eigenpairs(const Eigen::MatrixXd& A, const Eigen::MatrixXd& N);
Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& A, const Eigen::MatrixXd& N);

/// A^-1 b for positive definite A
Eigen::MatrixXd definite_solution(const Eigen::MatrixXd& A, const Eigen::MatrixXd& b);

/// lower triangular L with A = L L^T
Eigen::MatrixXd cholesky_factor(const Eigen::MatrixXd& A);

/// the smallest x with the smallest |A x - b|
Eigen::MatrixXd least_squares(const Eigen::MatrixXd& A, const Eigen::MatrixXd& b);

/// number of columns that are independent up to the tolerance, relative to the greatest
Eigen::Index rank(const Eigen::MatrixXd& A, double tolerance);

/// Q of A = Q R
Eigen::MatrixXd orthogonal_factor(const Eigen::MatrixXd& A);

}  // namespace cgp_test
