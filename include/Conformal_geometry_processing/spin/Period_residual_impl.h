// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_PERIOD_RESIDUAL_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_PERIOD_RESIDUAL_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/spin/Period_residual.h>
#include <Conformal_geometry_processing/spin/edge_derivative.h>
#include <Conformal_geometry_processing/spin/transformed_edges.h>

#include <Eigen/Core>

#include <cmath>

namespace Conformal_geometry_processing {
namespace internal {

CGP_INLINE Period_residual::Period_residual(const Surface_ref& surface,
                                            const Exactness_constraints& exactness)
    : m_surface(surface), m_exactness(exactness)
{}

CGP_INLINE void Period_residual::set_spins(const Spins& lambda)
{
  m_lambda = lambda;
  const Eigen::MatrixX3d edges = transformed_edges(m_surface, lambda);
  m_length = std::sqrt(m_exactness.weights.cwiseAbs().dot(edges.rowwise().squaredNorm()));
  m_values = periods(edges);
}

// The length counts as constant: its change is multiplied by values that become zero.
CGP_INLINE Eigen::VectorXd Period_residual::change(const Spins& dlambda) const
{
  return periods(edge_change(m_surface, m_lambda, dlambda));
}

CGP_INLINE auto Period_residual::gradient(const Eigen::VectorXd& y) const -> Spins
{
  const Eigen::MatrixX3d edges = m_exactness.forms.one_forms * y.reshaped(y.size() / 3, 3);
  return edge_gradient(m_surface, m_lambda, (m_exactness.weights / m_length).asDiagonal() * edges);
}

CGP_INLINE Eigen::VectorXd Period_residual::periods(const Eigen::MatrixX3d& edges) const
{
  return m_exactness.forms.coefficients(m_exactness.weights, edges).reshaped() / m_length;
}

}  // namespace internal
}  // namespace Conformal_geometry_processing

#endif
