// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/spin/Exactness_constraints.h>
#include <Conformal_geometry_processing/spin/Spin_residual.h>

#include <Eigen/Core>

#include <cmath>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgSpin
/// \brief the harmonic part of the transformed edges, three numbers for each loop around handles
/// and holes: its norm is `Exactness_constraints::period_defect()`, zero if the surface closes.
class Period_residual : public Spin_residual {
 public:
  /// of the square of the residual, at first: leaves defects that nobody sees
  static constexpr double default_weight = 1e4;

  /// \param exactness of the surface; both must outlive the object
  Period_residual(const Surface_ref& surface, const Exactness_constraints& exactness);

  void set_spins(const Spins& lambda) override;
  Eigen::VectorXd values() const override { return std::sqrt(m_weight) * m_values; }
  Eigen::VectorXd change(const Spins& dlambda) const override;
  Spins gradient(const Eigen::VectorXd& y) const override;
  bool is_few() const override { return true; }

  /// \param b factor of the square of the residual
  void set_weight(double b) { m_weight = b; }

 private:
  Eigen::VectorXd periods(const Eigen::MatrixX3d& edges) const;

  Surface_ref m_surface;
  const Exactness_constraints& m_exactness;
  Spins m_lambda;
  double m_weight = default_weight;
  double m_length = 1;  // of the edges
  Eigen::VectorXd m_values;
};

}  // namespace Conformal_geometry_processing::internal
