// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/spin/Exactness_constraints.h>
#include <Conformal_geometry_processing/spin/Spin_residual.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgSpin
/// \brief the harmonic part of the transformed edges, three numbers for each loop around handles
/// and holes: its norm is `Exactness_constraints::period_defect()`, zero if the surface closes.
class Period_residual : public Spin_residual {
 public:
  /// \param exactness of the surface; both must outlive the object
  Period_residual(const Surface_ref& surface, const Exactness_constraints& exactness);

  void set_spins(const Spins& lambda) override;
  Eigen::VectorXd values() const override { return m_values; }
  Eigen::VectorXd change(const Spins& dlambda) const override;
  Spins gradient(const Eigen::VectorXd& y) const override;
  double damping() const override { return (std::min)(0.01, m_values.norm()); }

 private:
  Eigen::VectorXd periods(const Eigen::MatrixX3d& edges) const;

  Surface_ref m_surface;
  const Exactness_constraints& m_exactness;
  Spins m_lambda;
  double m_length = 1;  // of the edges
  Eigen::VectorXd m_values;
};

}  // namespace Conformal_geometry_processing::internal
