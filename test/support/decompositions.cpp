// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "support/decompositions.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>

namespace cgp_test {

Eigenpairs symmetric_eigenpairs(const Eigen::MatrixXd& A)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(A);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& A)
{
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A, Eigen::EigenvaluesOnly).eigenvalues();
}

Eigenpairs symmetric_eigenpairs(const Eigen::MatrixXd& A, const Eigen::MatrixXd& N)
{
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(A, N);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& A, const Eigen::MatrixXd& N)
{
  return symmetric_eigenpairs(A, N).values;
}

Eigen::MatrixXd definite_solution(const Eigen::MatrixXd& A, const Eigen::MatrixXd& b)
{
  return A.ldlt().solve(b);
}

Eigen::MatrixXd cholesky_factor(const Eigen::MatrixXd& A)
{
  return A.llt().matrixL();
}

Eigen::MatrixXd least_squares(const Eigen::MatrixXd& A, const Eigen::MatrixXd& b)
{
  return A.completeOrthogonalDecomposition().solve(b);
}

Eigen::Index rank(const Eigen::MatrixXd& A, double tolerance)
{
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(A);
  return qr.setThreshold(tolerance).rank();
}

Eigen::MatrixXd orthogonal_factor(const Eigen::MatrixXd& A)
{
  return Eigen::HouseholderQR<Eigen::MatrixXd>(A).householderQ();
}

}  // namespace cgp_test
