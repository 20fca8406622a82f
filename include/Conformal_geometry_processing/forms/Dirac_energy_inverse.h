// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_FORMS_DIRAC_ENERGY_INVERSE_H
#define CONFORMAL_GEOMETRY_PROCESSING_FORMS_DIRAC_ENERGY_INVERSE_H

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/linear_algebra/dense/block_operators.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/conjugate_gradients.h>

#include <Eigen/Core>

#include <algorithm>

namespace Conformal_geometry_processing {

/// \ingroup PkgForms
/// \brief solves D^H M_F D Y = c on a connected closed surface, where constants are the kernel.
///
/// By conjugate gradients on the matrix X = D^H M_F D itself, preconditioned by whatever factor is
/// at hand: that of X plus a small multiple of M_V, as the eigenvalue problem makes it, takes some
/// five iterations; those of nearby matrices do as well. So no second factor is needed.
///
/// \tparam Solver a model of `SparseHermitianSolver` for quaternions
template <class Solver>
class Dirac_energy_inverse {
 public:
  using Vectors = Block<Quaternion<double>>;

  /// keeps references
  /// \param X `dirac_energy()` for rho = 0 \param areas M_V
  /// \param solver has factorized X + s M_V for a small s > 0, or a matrix like it
  Dirac_energy_inverse(const Hermitian_sparse_matrix<Quaternion<double>>& X,
                       const Eigen::VectorXd& areas, const Solver& solver)
      : m_X(X), m_areas(areas), m_solver(solver)
  {}

  /// \brief the solutions Y with sum_i M_V,i Y_i = 0, one for each column of c.
  ///
  /// The mean of c, which is in no image of X, is taken off before.
  /// \throw Solver_error if the solver fails, or the iterations do not converge
  Vectors operator()(const Vectors& c) const
  {
    Vectors Y(c.rows(), c.cols());
    for (Eigen::Index first = 0; first < c.cols(); first += at_once) {
      const Eigen::Index count = (std::min)(at_once, c.cols() - first);
      Y.middleCols(first, count) = solve(c.middleCols(first, count));
    }
    return Y;
  }

 private:
  static constexpr double worst_error = 1e-6;  // relative, in the energy norm
  static constexpr Eigen::Index at_once = 8;   // columns: the iterations hold five such blocks

  Vectors solve(Vectors c) const
  {
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(c.rows());
    remove_mean(c, ones);
    const auto factor = inverse_operator(m_solver);
    // The factor blows constants up, which X does not see: rounding would go with them.
    const auto precondition = [&](const Vectors& r, Vectors& z) {
      factor(r, z);
      remove_mean(z, ones);
    };
    Conjugate_gradients_options options;
    options.tolerance = 1e-11;
    Vectors Y;
    const auto result = conjugate_gradients(block_operator(m_X), precondition, c, Y, options);
    // Slivers leave fewer digits, after which the iterations break down.
    if (!result.converged && !(result.estimates.maxCoeff() <= worst_error))
      throw Solver_error("Dirac_energy_inverse", "the iterations do not converge");
    remove_mean(Y, m_areas);
    return Y;
  }

  static void remove_mean(Vectors& v, const Eigen::VectorXd& masses)
  {
    for (auto column : v.colwise()) {
      Quaternion<double> sum{};
      for (Eigen::Index i = 0; i < v.rows(); ++i) sum += masses[i] * column[i];
      sum *= 1 / masses.sum();
      for (Quaternion<double>& value : column) value -= sum;
    }
  }

  const Hermitian_sparse_matrix<Quaternion<double>>& m_X;
  const Eigen::VectorXd& m_areas;
  const Solver& m_solver;
};

}  // namespace Conformal_geometry_processing

#endif
