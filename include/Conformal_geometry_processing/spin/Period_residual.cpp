// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Period_residual.h>

#include <Conformal_geometry_processing/spin/edge_derivative.h>
#include <Conformal_geometry_processing/spin/transformed_edges.h>

#include <Eigen/Core>

#include <cmath>

namespace Conformal_geometry_processing::internal {

Period_residual::Period_residual(const Surface_ref& surface, const Exactness_constraints& exactness)
    : m_surface(surface), m_exactness(exactness)
{}

void Period_residual::set_spins(const Spins& lambda)
{
  m_lambda = lambda;
  const Eigen::MatrixX3d edges = transformed_edges(m_surface, lambda);
  m_length = std::sqrt(m_exactness.weights.cwiseAbs().dot(edges.rowwise().squaredNorm()));
  m_values = periods(edges);
}

// The length counts as constant: its change is multiplied by values that become zero.
Eigen::VectorXd Period_residual::change(const Spins& dlambda) const
{
  return std::sqrt(m_weight) * periods(edge_change(m_surface, m_lambda, dlambda));
}

auto Period_residual::gradient(const Eigen::VectorXd& y) const -> Spins
{
  const Eigen::MatrixX3d edges = m_exactness.forms.one_forms * y.reshaped(y.size() / 3, 3);
  const Eigen::VectorXd weights = std::sqrt(m_weight) / m_length * m_exactness.weights;
  return edge_gradient(m_surface, m_lambda, weights.asDiagonal() * edges);
}

Eigen::VectorXd Period_residual::periods(const Eigen::MatrixX3d& edges) const
{
  return m_exactness.forms.coefficients(m_exactness.weights, edges).reshaped() / m_length;
}

}  // namespace Conformal_geometry_processing::internal
