// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_POSITION_RESIDUAL_TEMPLATES_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_POSITION_RESIDUAL_TEMPLATES_H

#include <Conformal_geometry_processing/spin/Poisson_reconstruction_templates.h>
#include <Conformal_geometry_processing/spin/Position_residual.h>
#include <Conformal_geometry_processing/spin/edge_derivative.h>
#include <Conformal_geometry_processing/spin/transformed_edges.h>

#include <Eigen/Core>

#include <cmath>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

template <class SolverTraits>
Position_residual<SolverTraits>::Position_residual(
    const Surface_ref& surface, const Poisson_reconstruction<SolverTraits>& reconstruction,
    std::vector<Control_point> points)
    : m_surface(surface), m_reconstruction(reconstruction), m_points(std::move(points))
{}

template <class SolverTraits>
void Position_residual<SolverTraits>::set_targets(Points targets)
{
  m_targets = std::move(targets);
}

template <class SolverTraits>
void Position_residual<SolverTraits>::set_spins(const Spins& lambda)
{
  m_lambda = lambda;
  const Points h =
      positions_of(m_points, m_reconstruction.positions(transformed_edges(m_surface, lambda)));
  m_placement = placement(h, m_targets);
  const Points placed = m_placement.apply(h);
  m_distances = placed - m_targets;
  m_motions = shape_motions(placed, number_of_shape_motions(m_targets));
}

template <class SolverTraits>
Eigen::VectorXd Position_residual<SolverTraits>::values() const
{
  return std::sqrt(m_weight) * (m_motions.transpose() * m_distances.reshaped());
}

template <class SolverTraits>
Eigen::VectorXd Position_residual<SolverTraits>::change(const Spins& dlambda) const
{
  const Points dh =
      positions_of(m_points, m_reconstruction.positions(edge_change(m_surface, m_lambda, dlambda)));
  const Points moved = m_placement.scale * (m_placement.rotation * dh);
  return std::sqrt(m_weight) * (m_motions.transpose() * moved.reshaped());
}

template <class SolverTraits>
auto Position_residual<SolverTraits>::gradient(const Eigen::VectorXd& y) const -> Spins
{
  const Eigen::VectorXd z = std::sqrt(m_weight) * (m_motions * y);
  const Points forces =
      m_placement.scale * (m_placement.rotation.transpose() * z.reshaped(3, m_targets.cols()));
  Points all = Points::Zero(3, m_lambda.size());
  for (std::size_t k = 0; k < m_points.size(); ++k)
    for (std::size_t i = 0; i < m_points[k].vertices.size(); ++i)
      all.col(m_points[k].vertices[i]) += m_points[k].weights[static_cast<Eigen::Index>(i)] *
                                          forces.col(static_cast<Eigen::Index>(k));
  return edge_gradient(m_surface, m_lambda, m_reconstruction.edge_gradient(all));
}

}  // namespace internal
}  // namespace Conformal_geometry_processing

#ifndef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
namespace Conformal_geometry_processing {

extern template class internal::Position_residual<Default_solver_traits>;

}  // namespace Conformal_geometry_processing
#endif

#endif
