// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Quaternion_vector.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgSpin
/// \brief the residual r = (D - rho) lambda of the Dirac equation and its derivative
/// dr = A y - N d for changes y of lambda and d of rho, with A = D - rho and N d = B(d lambda).
///
/// r has one value for each sheet, weighted by M, the areas of the sheets; X = A^H M A. Where rho
/// is on faces, N d is d times the mean of lambda. All functions are O(sheets), and real-linear.
class Dirac_linearization {
 public:
  using Spins = Quaternion_vector<double>;

  /// \param surface must outlive the object
  /// \param rho in 1/length
  Dirac_linearization(const Surface_ref& surface, Curvature_potential rho, Spins lambda);

  const Spins& lambda() const { return m_lambda; }
  const Curvature_potential& rho() const { return m_rho; }

  /// r = A lambda, in 1/length, one value per sheet
  Spins residual() const { return apply(m_lambda); }

  Spins apply(const Spins& y) const;             ///< A y, one value per sheet
  Spins adjoint(const Spins& z) const;           ///< A^H M z, |V|
  Spins turn(const Eigen::VectorXd& d) const;    ///< N d, one value per sheet
  Eigen::VectorXd turned(const Spins& z) const;  ///< N^T M z, where rho is
  double squared_norm(const Spins& z) const;     ///< <z, M z>

 private:
  Surface_ref m_surface;
  Curvature_potential m_rho;
  Spins m_lambda;
};

}  // namespace Conformal_geometry_processing::internal
