// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/linear_algebra/dense/Solver_status.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Solver_ref.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgSpin
/// \brief the inner product K = M + s L of changes of rho at vertices, which approximates
///
///     integral a b + s <grad a, grad b>,
///
/// and the solution of (K + w M) d = b. M are the areas, and L is the cotan Laplacian, which
/// annihilates constants.
class Potential_metric {
 public:
  /// \param system whose surface is meant, and whose analysis is shared
  /// \param s >= 0, in the unit of area of the system
  Potential_metric(const Dirac_system& system, double s);

  /// \brief factors K + w M, for `solve_coupled()`.
  /// \throw Solver_error if the factorization fails
  void couple(double w);

  /// \brief (K + w M)^-1 b.
  /// \throw Solver_error if the solver fails
  Eigen::VectorXd solve_coupled(const Eigen::VectorXd& b) const;

  /// M, |V|
  const Eigen::VectorXd& areas() const { return m_areas; }

  /// K d, for each column of d
  Eigen::MatrixXd apply(const Eigen::MatrixXd& d) const;

  /// <d, K d>
  double squared_norm(const Eigen::VectorXd& d) const { return d.dot(apply(d).col(0)); }

 private:
  static void check(Solver_status status);

  Eigen::VectorXd m_areas;
  Hermitian_sparse_matrix<double> m_matrix;  // K
  Solver_ref<double> m_coupled;              // of K + w M
};

}  // namespace Conformal_geometry_processing::internal
