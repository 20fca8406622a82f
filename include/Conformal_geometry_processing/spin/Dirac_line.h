// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/linear_algebra/direct/Solver_ref.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Conformal_geometry_processing/spin/Dirac_solution.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>
#include <Conformal_geometry_processing/spin/follow_branch.h>

#include <Eigen/Core>

#include <optional>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgSpin
/// \brief predicts the spins of rho + t d on a closed surface from those of rho.
///
/// The derivative is soon wrong: d also couples lambda's soft modes, the other eigenvectors of D -
/// rho with eigenvalues near gamma, to one another, and on limbs these are near. In the span of
/// lambda, its derivative and the images of that under (X - mu M_V)^-1 M_V, which are ever more of
/// soft modes, the equation is solved exactly (`follow_branch()`).
///
/// Costs four solves with the factor at hand; a prediction is a combination of six vectors.
class Dirac_line {
 public:
  /// \param system whose factor is that of `at`
  /// \param rho in 1/length of the system, \param at its solution
  /// \param change d, \param dlambda derivative of lambda along d
  /// \pre the surface is closed
  Dirac_line(const Dirac_system& system, const Curvature_potential& rho, Dirac_solution at,
             const Eigen::VectorXd& change, const Quaternion_vector<double>& dlambda);

  /// \brief the solution predicted for t in [0, 1]; none where the branch turns away from lambda,
  /// or cannot be told from another.
  std::optional<Dirac_solution> at(double t) const;

  int number_of_solves() const { return m_solves; }  ///< with the factor, one right-hand side each

 private:
  Dirac_solution m_at;
  double m_length;                   // of its spins
  Block<Quaternion<double>> m_span;  // orthonormal with respect to the vertex areas
  Dirac_gram m_gram;                 // of the span
  int m_solves = 0;
};

}  // namespace Conformal_geometry_processing::internal
