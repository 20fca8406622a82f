// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Exactness_residual.h>

#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>
#include <Conformal_geometry_processing/spin/edge_derivative.h>
#include <Conformal_geometry_processing/spin/transformed_edges.h>

#include <Eigen/Core>

#include <cmath>

namespace Conformal_geometry_processing::internal {

Exactness_residual::Exactness_residual(const Surface_ref& surface,
                                       const Poisson_reconstruction& reconstruction)
    : m_surface(surface),
      m_reconstruction(reconstruction),
      m_roots(cotan_weights(surface).cwiseAbs().cwiseSqrt())
{}

void Exactness_residual::set_spins(const Spins& lambda)
{
  m_lambda = lambda;
  const Eigen::MatrixX3d edges = transformed_edges(m_surface, lambda);
  m_length = (m_roots.asDiagonal() * edges).norm();
  m_inexact = inexact_part(edges);
}

Eigen::VectorXd Exactness_residual::values() const
{
  return std::sqrt(m_weight) * m_inexact.reshaped();
}

// The length counts as constant: in the gauge of the derivative it hardly changes.
Eigen::VectorXd Exactness_residual::change(const Spins& dlambda) const
{
  if (m_weight == 0) return Eigen::VectorXd::Zero(m_inexact.size());  // saves a solve
  return std::sqrt(m_weight) * inexact_part(edge_change(m_surface, m_lambda, dlambda)).reshaped();
}

auto Exactness_residual::gradient(const Eigen::VectorXd& y) const -> Spins
{
  if (m_weight == 0) return Spins::Constant(m_lambda.size(), {});
  Eigen::MatrixX3d q =
      (std::sqrt(m_weight) / m_length) * m_roots.asDiagonal() * y.reshaped(y.size() / 3, 3);
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(m_roots.size());
  const Points of_positions = codifferential(m_surface, ones, q).transpose();
  q -= m_reconstruction.edge_gradient(of_positions);
  return edge_gradient(m_surface, m_lambda, q);
}

Eigen::MatrixX3d Exactness_residual::inexact_part(const Eigen::MatrixX3d& edges) const
{
  const Points f = m_reconstruction.positions(edges);
  return m_roots.asDiagonal() * (edges - differential(m_surface, f.transpose())) / m_length;
}

}  // namespace Conformal_geometry_processing::internal
