// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>
#include <Conformal_geometry_processing/spin/Spin_residual.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgSpin
/// \brief the part of the transformed edges that is not exact, e - d0 f with the positions f of
/// `Poisson_reconstruction`; its norm is the `closure_residual()`.
///
/// Inexact edges come from a rho that varies too fast for the mesh, and from open handles.
class Exactness_residual : public Spin_residual {
 public:
  /// \param reconstruction of the surface; both must outlive the object
  Exactness_residual(const Surface_ref& surface, const Poisson_reconstruction& reconstruction);

  /// \param c factor of the square of the residual; 0 leaves it out
  void set_weight(double c) { m_weight = c; }
  double weight() const { return m_weight; }

  /// the `closure_residual()`
  double size() const { return m_inexact.norm(); }

  void set_spins(const Spins& lambda) override;
  Eigen::VectorXd values() const override;
  Eigen::VectorXd change(const Spins& dlambda) const override;
  Spins gradient(const Eigen::VectorXd& y) const override;

 private:
  /// the inexact part of edges, scaled by the roots of |w| and by the length of the edges
  Eigen::MatrixX3d inexact_part(const Eigen::MatrixX3d& edges) const;

  Surface_ref m_surface;
  const Poisson_reconstruction& m_reconstruction;
  Eigen::VectorXd m_roots;  // of |w|
  double m_weight = 0, m_length = 1;
  Spins m_lambda;
  Eigen::MatrixX3d m_inexact;
};

}  // namespace Conformal_geometry_processing::internal
