// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/spin/Spin_residual.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgSpin
/// \brief the root of w times the areas times the deviation of `log_scales()` from wanted ones.
///
/// The mean of the deviation over the whole surface is free, because the total area is kept. Where
/// weights select a part, the mean over this part is not: it must not grow or shrink as a whole.
class Scale_residual : public Spin_residual {
 public:
  /// \param areas |V|
  /// \param wanted |V|, logs of factors of lengths
  /// \param weights |V|, of the areas, not negative; empty: 1
  Scale_residual(Eigen::VectorXd areas, Eigen::VectorXd wanted,
                 const Eigen::VectorXd& weights = {});

  /// \param w in 1/area
  void set_weight(double w) { m_weight = w; }

  void set_spins(const Spins& lambda) override;
  Eigen::VectorXd values() const override;
  Eigen::VectorXd change(const Spins& dlambda) const override;
  Spins gradient(const Eigen::VectorXd& y) const override;

  /// 2 w times the areas: u has the derivative 2 / |lambda| in one of four directions, and none in
  /// the others
  Eigen::VectorXd stiffness() const override { return 2 * m_weight * m_masses; }

 private:
  Eigen::VectorXd weighted(Eigen::VectorXd u) const;

  Eigen::VectorXd m_areas, m_masses, m_wanted;
  double m_weight = 1;
  Spins m_lambda;
};

}  // namespace Conformal_geometry_processing::internal
