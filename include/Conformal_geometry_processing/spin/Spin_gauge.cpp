// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Spin_gauge.h>

#include <Quaternionic_linear_algebra/dense/block_operators.h>

#include <Eigen/Core>

#include <cmath>
#include <utility>

namespace Conformal_geometry_processing::internal {

auto Spin_gauge::normalized(Spins lambda) const -> Spins
{
  if (!m_is_free) components(lambda) *= std::sqrt(m_system.area() / m_system.squared_norm(lambda));
  return lambda;
}

auto Spin_gauge::projected(const Spins& lambda, Spins y) const -> Spins
{
  if (m_is_free) return y;
  y = m_system.projected(std::move(y)).col(0);
  const Quaternion<double> q =
      reduced_to(m_system.coefficients(),
                 m_system.sum(inner_product(lambda, m_system.areas(), y))) *
      (-1 / m_system.squared_norm(lambda));
  add_multiple(y, lambda, q);
  return y;
}

auto Spin_gauge::projected_gradient(const Spins& lambda, Spins g) const -> Spins
{
  if (m_is_free) return g;
  g = m_system.projected(std::move(g)).col(0);
  const Quaternion<double> q =
      reduced_to(m_system.coefficients(), m_system.sum(inner_product(lambda, g))) *
      (-1 / m_system.squared_norm(lambda));
  for (Eigen::Index v = 0; v < g.size(); ++v) g[v] += m_system.areas()[v] * (lambda[v] * q);
  return g;
}

}  // namespace Conformal_geometry_processing::internal
