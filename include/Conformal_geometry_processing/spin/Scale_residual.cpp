// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Scale_residual.h>

#include <Conformal_geometry_processing/spin/log_scales.h>

#include <Eigen/Core>

#include <cmath>
#include <utility>

namespace Conformal_geometry_processing::internal {

Scale_residual::Scale_residual(Eigen::VectorXd areas, Eigen::VectorXd wanted,
                               const Eigen::VectorXd& weights)
    : m_areas(std::move(areas)), m_masses(m_areas), m_wanted(std::move(wanted))
{
  if (weights.size() > 0) m_masses.array() *= weights.array();
}

void Scale_residual::set_spins(const Spins& lambda)
{
  m_lambda = lambda;
}

Eigen::VectorXd Scale_residual::values() const
{
  return weighted(log_scales(m_lambda) - m_wanted);
}

Eigen::VectorXd Scale_residual::change(const Spins& dlambda) const
{
  return weighted(log_scale_change(m_lambda, dlambda));
}

auto Scale_residual::gradient(const Eigen::VectorXd& y) const -> Spins
{
  Eigen::VectorXd z = (m_weight * m_masses).cwiseSqrt().cwiseProduct(y);
  z -= m_areas * (z.sum() / m_areas.sum());
  return log_scale_gradient(m_lambda, z);
}

Eigen::VectorXd Scale_residual::weighted(Eigen::VectorXd u) const
{
  u.array() -= m_areas.dot(u) / m_areas.sum();
  return (m_weight * m_masses).cwiseSqrt().cwiseProduct(u);
}

}  // namespace Conformal_geometry_processing::internal
