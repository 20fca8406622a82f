// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_POSITION_RESIDUAL_TEMPLATES_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_POSITION_RESIDUAL_TEMPLATES_H

#include <Conformal_geometry_processing/operators/mass_matrices.h>
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
    std::vector<Control_point> points, Eigen::VectorXd masses)
    : m_surface(surface),
      m_reconstruction(reconstruction),
      m_points(std::move(points)),
      m_masses(std::move(masses)),
      m_radius(std::sqrt(vertex_areas(surface).sum() / (4 * std::acos(-1.))))
{
  if (m_masses.size() == 0) m_masses.setOnes(static_cast<Eigen::Index>(m_points.size()));
}

template <class SolverTraits>
void Position_residual<SolverTraits>::set_targets(Points targets)
{
  m_targets = std::move(targets);
  m_size = Shape_motions(m_targets / m_radius, m_masses).size();
}

template <class SolverTraits>
void Position_residual<SolverTraits>::set_spins(const Spins& lambda)
{
  m_lambda = lambda;
  const Points h =
      positions_of(m_points, m_reconstruction.positions(transformed_edges(m_surface, lambda)));
  m_placement = placement(h, m_targets, m_masses);
  const Points placed = m_placement.apply(h);
  m_distances = placed - m_targets;
  m_motions = Shape_motions(placed / m_radius, m_masses);
}

template <class SolverTraits>
double Position_residual<SolverTraits>::damping() const
{
  const double share = 0.25;
  return share * values().norm();
}

template <class SolverTraits>
Eigen::VectorXd Position_residual<SolverTraits>::change(const Spins& dlambda) const
{
  const Points dh =
      positions_of(m_points, m_reconstruction.positions(edge_change(m_surface, m_lambda, dlambda)));
  return coordinates(m_placement.scale * (m_placement.rotation * dh));
}

template <class SolverTraits>
auto Position_residual<SolverTraits>::gradient(const Eigen::VectorXd& y) const -> Spins
{
  const Points z = m_motions.motion(y).reshaped(3, m_targets.cols()) *
                   (m_weight * m_masses).cwiseSqrt().asDiagonal();
  const Points forces = m_placement.scale / m_radius * (m_placement.rotation.transpose() * z);
  Points all = Points::Zero(3, m_lambda.size());
  for (std::size_t k = 0; k < m_points.size(); ++k)
    for (std::size_t i = 0; i < m_points[k].vertices.size(); ++i)
      all.col(m_points[k].vertices[i]) += m_points[k].weights[static_cast<Eigen::Index>(i)] *
                                          forces.col(static_cast<Eigen::Index>(k));
  return edge_gradient(m_surface, m_lambda, m_reconstruction.edge_gradient(all));
}

template <class SolverTraits>
Eigen::VectorXd Position_residual<SolverTraits>::coordinates(const Points& v) const
{
  const Points scaled = v / m_radius * (m_weight * m_masses).cwiseSqrt().asDiagonal();
  return m_motions.coordinates(scaled.reshaped(), m_size);
}

}  // namespace internal
}  // namespace Conformal_geometry_processing

#ifndef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
namespace Conformal_geometry_processing {

extern template class internal::Position_residual<Default_solver_traits>;

}  // namespace Conformal_geometry_processing
#endif

#endif
