// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Position_residual.h>

#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/transformed_edges.h>

#include <Eigen/Geometry>
#include <Eigen/SparseCore>

namespace Conformal_geometry_processing::internal {

/// the points, and six near their mean that decide what they leave open
Points with_axes(const Points& points, const Eigen::VectorXd& shares)
{
  const double size = 1e-6;  // its square is what they count
  Points all(3, points.cols() + 6);
  all.leftCols(points.cols()) = points;
  const Eigen::Vector3d mean = points * shares;
  all.middleCols(points.cols(), 3) = (size * Eigen::Matrix3d::Identity()).colwise() + mean;
  all.rightCols(3) = (-size * Eigen::Matrix3d::Identity()).colwise() + mean;
  return all;
}

Alignment placement(const Points& points, const Points& targets, const Eigen::VectorXd& masses)
{
  Eigen::VectorXd all = Eigen::VectorXd::Ones(points.cols() + 6);
  if (masses.size() > 0) all.head(points.cols()) = masses;
  const Eigen::VectorXd shares = all.head(points.cols()) / all.head(points.cols()).sum();
  return align(with_axes(points, shares), with_axes(targets, shares), all);
}

/// translations, turns and scaling about the mean, 3k x 7
Eigen::MatrixXd similarity_motions(const Points& points)
{
  const Eigen::Vector3d mean = points.rowwise().mean();
  Eigen::MatrixXd motions(points.size(), 7);
  for (Eigen::Index k = 0; k < points.cols(); ++k) {
    const Eigen::Vector3d arm = points.col(k) - mean;
    auto block = motions.middleRows(3 * k, 3);
    block.leftCols(3).setIdentity();
    for (int axis = 0; axis < 3; ++axis)
      block.col(3 + axis) = Eigen::Vector3d::Unit(axis).cross(arm);
    block.col(6) = arm;
  }
  return motions;
}

Shape_motions::Shape_motions(const Points& points, const Eigen::VectorXd& masses)
{
  const double line = 1e-6;  // points this near to a line are on it
  const Eigen::VectorXd roots = masses.cwiseSqrt().transpose().replicate<3, 1>().reshaped();
  m_qr.compute(roots.asDiagonal() * similarity_motions(points));
  m_qr.setThreshold(line);
}

Eigen::VectorXd Shape_motions::coordinates(const Eigen::VectorXd& v, Eigen::Index size) const
{
  const Eigen::VectorXd all = m_qr.householderQ().adjoint() * v;
  return all.tail(size);
}

Eigen::VectorXd Shape_motions::motion(const Eigen::VectorXd& y) const
{
  Eigen::VectorXd all = Eigen::VectorXd::Zero(m_qr.rows());
  all.tail(y.size()) = y;
  return m_qr.householderQ() * all;
}

/// the transpose of `positions_of()`
Eigen::SparseMatrix<double> loads_of(const std::vector<Control_point>& points,
                                     Eigen::Index vertices)
{
  Eigen::SparseMatrix<double> loads(vertices, static_cast<Eigen::Index>(points.size()));
  for (Eigen::Index k = 0; k < loads.cols(); ++k) {
    const Control_point& p = points[static_cast<std::size_t>(k)];
    for (std::size_t i = 0; i < p.vertices.size(); ++i)
      loads.coeffRef(p.vertices[i], k) += p.weights[static_cast<Eigen::Index>(i)];
  }
  return loads;
}

Position_residual::Position_residual(const Surface_ref& surface,
                                     const Poisson_reconstruction& reconstruction,
                                     std::vector<Control_point> points, Eigen::VectorXd masses,
                                     bool has_to_vanish)
    : m_surface(surface),
      m_reconstruction(reconstruction),
      m_points(std::move(points)),
      m_masses(std::move(masses)),
      m_areas(vertex_areas(surface)),
      m_radius(std::sqrt(m_areas.sum() / (4 * std::acos(-1.)))),
      m_has_to_vanish(has_to_vanish)
{
  if (m_masses.size() == 0) m_masses.setOnes(static_cast<Eigen::Index>(m_points.size()));
  if (is_few()) m_influences = reconstruction.edge_gradient(loads_of(m_points, m_areas.size()));
}

void Position_residual::set_targets(Points targets)
{
  m_targets = std::move(targets);
  m_size = Shape_motions(m_targets / m_radius, m_masses).size();
}

void Position_residual::set_spins(const Spins& lambda)
{
  m_lambda = lambda;
  const Points h = points_of(transformed_edges(m_surface, lambda));
  m_placement = placement(h, m_targets, m_masses);
  const Points placed = m_placement.apply(h);
  m_distances = placed - m_targets;
  m_motions = Shape_motions(placed / m_radius, m_masses);
}

Eigen::VectorXd Position_residual::stiffness() const
{
  if (is_few()) return {};
  const double pi = std::acos(-1.);
  return 2 * std::sqrt(m_stiffness * m_weight / pi) / (m_radius * m_radius) * m_areas;
}

Eigen::VectorXd Position_residual::change(const Spins& dlambda) const
{
  const Points dh = points_of(edge_change(m_surface, m_lambda, dlambda));
  return coordinates(m_placement.scale * (m_placement.rotation * dh));
}

auto Position_residual::gradient(const Eigen::VectorXd& y) const -> Spins
{
  const Points z = m_motions.motion(y).reshaped(3, m_targets.cols()) *
                   (m_weight * m_masses).cwiseSqrt().asDiagonal();
  const Points forces = m_placement.scale / m_radius * (m_placement.rotation.transpose() * z);
  return edge_gradient(m_surface, m_lambda, edge_forces(forces));
}

Points Position_residual::points_of(const Eigen::MatrixX3d& edges) const
{
  if (is_few()) return edges.transpose() * m_influences;
  return positions_of(m_points, m_reconstruction.positions(edges));
}

Eigen::MatrixX3d Position_residual::edge_forces(const Points& forces) const
{
  if (is_few()) return m_influences * forces.transpose();
  return m_reconstruction.edge_gradient(loads_of(m_points, m_areas.size()) * forces.transpose());
}

Eigen::VectorXd Position_residual::coordinates(const Points& v) const
{
  const Points scaled = v / m_radius * (m_weight * m_masses).cwiseSqrt().asDiagonal();
  return m_motions.coordinates(scaled.reshaped(), m_size);
}

}  // namespace Conformal_geometry_processing::internal
