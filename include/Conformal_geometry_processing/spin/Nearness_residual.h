// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/spin/Spin_residual.h>

#include <Eigen/Core>

#include <utility>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgSpin
/// \brief the roots of masses times lambda - 1: with a free boundary, where infinitely many spins
/// solve the equation, those nearest to 1 are wanted (`nearness_weight()`).
class Nearness_residual : public Spin_residual {
 public:
  /// \param masses |V|
  explicit Nearness_residual(Eigen::VectorXd masses) : m_masses(std::move(masses)) {}

  /// multiplies the masses
  void scale(double factor) { m_masses *= factor; }

  void set_spins(const Spins& lambda) override { m_lambda = lambda; }
  Eigen::VectorXd values() const override;
  Eigen::VectorXd change(const Spins& dlambda) const override;
  Spins gradient(const Eigen::VectorXd& y) const override;
  Eigen::VectorXd stiffness() const override { return m_masses; }

 private:
  Eigen::VectorXd m_masses;
  Spins m_lambda;
};

}  // namespace Conformal_geometry_processing::internal
