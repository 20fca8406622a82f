// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Nearness_residual.h>

#include <Eigen/Core>

#include <cmath>

namespace Conformal_geometry_processing::internal {

Eigen::VectorXd Nearness_residual::values() const
{
  return change(m_lambda - Spins::Constant(m_lambda.size(), {1, 0, 0, 0}));
}

Eigen::VectorXd Nearness_residual::change(const Spins& dlambda) const
{
  Spins scaled = dlambda;
  for (Eigen::Index v = 0; v < scaled.size(); ++v) scaled[v] *= std::sqrt(m_masses[v]);
  return components(scaled).reshaped();
}

auto Nearness_residual::gradient(const Eigen::VectorXd& y) const -> Spins
{
  Spins q(m_masses.size());
  components(q) = y.reshaped(4, m_masses.size()) * m_masses.cwiseSqrt().asDiagonal();
  return q;
}

}  // namespace Conformal_geometry_processing::internal
