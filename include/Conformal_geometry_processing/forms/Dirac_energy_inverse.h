// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_FORMS_DIRAC_ENERGY_INVERSE_H
#define CONFORMAL_GEOMETRY_PROCESSING_FORMS_DIRAC_ENERGY_INVERSE_H

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/linear_algebra/dense/block_operators.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

namespace internal {

/// \ingroup PkgForms
/// \brief solves D^H M_F D Y = c on a connected closed surface, where the kernel consists of the
/// constants.
///
/// Uses conjugate gradients on the matrix X = D^H M_F D itself, preconditioned by any available
/// factor: that of X plus a small multiple of M_V, which the eigenvalue problem provides, needs
/// about five iterations; factors of nearby matrices work as well. So no second factor is needed.
///
/// \tparam Solver a model of `SparseHermitianSolver` for quaternions
template <class Solver>
class Dirac_energy_inverse {
 public:
  using Vectors = Block<Quaternion<double>>;

  /// keeps references
  /// \param X `dirac_energy()` for rho = 0
  /// \param areas M_V
  /// \param solver has factorized X + s M_V for a small s > 0, or a similar matrix
  Dirac_energy_inverse(const Hermitian_sparse_matrix<Quaternion<double>>& X,
                       const Eigen::VectorXd& areas, const Solver& solver);

  /// \brief the solutions Y with sum_i M_V,i Y_i = 0, one for each column of c.
  ///
  /// Removes the mean of c first, because it is not in the range of X.
  /// \throw Solver_error if the solver fails, or the iterations do not converge
  Vectors operator()(const Vectors& c) const;

 private:
  static constexpr double worst_error = 1e-6;  // relative, in the energy norm
  static constexpr Eigen::Index at_once = 8;   // columns per solve: the iterations hold five such
                                               // blocks

  Vectors solve(Vectors c) const;
  static void remove_mean(Vectors& v, const Eigen::VectorXd& masses);

  const Hermitian_sparse_matrix<Quaternion<double>>& m_X;
  const Eigen::VectorXd& m_areas;
  const Solver& m_solver;
};

}  // namespace internal

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/forms/Dirac_energy_inverse_templates.h>
#endif

#endif
