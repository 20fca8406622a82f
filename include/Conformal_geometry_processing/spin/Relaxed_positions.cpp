// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Relaxed_positions.h>

#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <Eigen/Geometry>
#include <Eigen/SparseCore>

#include <algorithm>

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
  const Points h = points_at(lambda);
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
  return edge_gradient(m_surface, m_lambda, edge_forces(forces(y)));
}

// One for each point: that of its influences, by the axes of the force.
Spin_columns Position_residual::columns() const
{
  Spin_columns c{edge_gradients(m_surface, m_lambda, m_influences),
                 Block<Quaternion<double>>(m_targets.cols(), m_size)};
  for (Eigen::Index k = 0; k < m_size; ++k) {
    const Points f = forces(Eigen::VectorXd::Unit(m_size, k));
    for (Eigen::Index p = 0; p < f.cols(); ++p)
      c.factors(p, k) = imaginary(Eigen::Vector3d(f.col(p)));
  }
  return c;
}

Points Position_residual::forces(const Eigen::VectorXd& y) const
{
  const Points z = m_motions.motion(y).reshaped(3, m_targets.cols()) *
                   (m_weight * m_masses).cwiseSqrt().asDiagonal();
  return m_placement.scale / m_radius * (m_placement.rotation.transpose() * z);
}

Points Position_residual::points_at(const Spins& lambda) const
{
  return points_of(transformed_edges(m_surface, lambda));
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

constexpr double met = 1e-9;        // of the distances, by R
constexpr double less_curved = 10;  // the misfit of sheets, by the default, which asks for less
                                    // curvature: with no rho wanted, for edges that close up
constexpr double stiffness = 60;    // of the misfit, by the default: large distances would be
                                    // met by shear, before rho' grows from nothing
constexpr double least_hold = 10;
constexpr double largest_weight = 1e6;  // of distances by R: leaves little to `meet_few()`, and
                                        // steps need not follow the curve of met targets

inline std::optional<Period_residual> periods_of(Spin_transformation& transformation)
{
  const Exactness_constraints* const closing = transformation.closing();
  if (!closing) return std::nullopt;
  return Period_residual(transformation.system().surface(), *closing);
}

inline std::vector<Control_point> without_anchors(const Relaxed_positions::Problem& problem)
{
  return {problem.points.begin(),
          problem.points.end() - static_cast<std::ptrdiff_t>(problem.anchors)};
}

Relaxed_positions::Relaxed_positions(Transformation& transformation, Problem problem,
                                     const Points& targets, const Relaxed_scales_options& options)
    : m_transformation(transformation),
      m_problem(std::move(problem)),
      m_positions(transformation.system().surface(), transformation.reconstruction(),
                  without_anchors(m_problem), m_problem.masses),
      m_periods(periods_of(transformation)),
      m_scales(transformation.system(), m_problem.rho, m_problem.scales, residuals(),
               completed(options))
{
  m_positions.set_stiffness(m_scales.spins().weights().sum());
  set_weight(m_problem.weight);
  set_targets(targets);
}

Spin_residuals Relaxed_positions::residuals()
{
  if (m_problem.anchors > 0)
    m_anchors.emplace(m_transformation.system().surface(), m_transformation.reconstruction(),
                      m_problem.points, anchor_masses(), false);
  Spin_residuals all;
  if (!m_anchors || is_exact()) all.push_back(&m_positions);
  if (m_periods) all.push_back(&*m_periods);
  if (m_anchors) all.push_back(&*m_anchors);
  return all;
}

// Under the one similarity of all points, those that are not anchors are firm.
Eigen::VectorXd Relaxed_positions::anchor_masses() const
{
  const double firmness = 10;
  const auto anchors = static_cast<Eigen::Index>(m_problem.anchors);
  Eigen::VectorXd masses = Eigen::VectorXd::Constant(
      static_cast<Eigen::Index>(m_problem.points.size()), m_hold / static_cast<double>(anchors));
  masses.head(masses.size() - anchors).setConstant((std::min)(firmness * m_hold, m_problem.weight));
  return masses;
}

bool Relaxed_positions::loosen()
{
  if (!m_anchors || m_hold <= least_hold) return false;
  m_hold /= 10;
  m_anchors->set_masses(anchor_masses());
  return true;
}

Relaxed_scales_options Relaxed_positions::completed(Relaxed_scales_options options)
{
  if (is_exact()) options.spins.weights.sheets *= less_curved;
  options.spins.weights.vertices =
      stiffness * default_vertex_weight(m_transformation.system().surface());
  options.is_met = [this] { return adapt(); };
  return options;
}

void Relaxed_positions::set_targets(const Points& targets)
{
  m_positions.set_targets(
      targets.leftCols(targets.cols() - static_cast<Eigen::Index>(m_problem.anchors)));
  if (m_anchors) m_anchors->set_targets(targets);
  if (!is_exact()) return;
  m_positions.set_spins(m_scales.spins().lambda());
  const double d = m_positions.distance();
  m_weight = std::clamp(16 / (d * d), 1., largest_weight);
  m_positions.set_weight(m_weight);
}

void Relaxed_positions::set_weight(double weight)
{
  m_problem.weight = weight;
  if (!is_exact()) m_positions.set_weight(weight);
}

bool Relaxed_positions::adapt()
{
  if (!is_exact()) return true;
  const double d = m_positions.distance();
  m_weight = std::clamp(16 / (d * d), m_weight, largest_weight);
  m_positions.set_weight(m_weight);
  return d * d * largest_weight < 16;
}

Relaxed_scales::End Relaxed_positions::go_on(const Go_further& go_further)
{
  const Relaxed_scales::End end = m_scales.go_on(go_further);
  const int most = 8, patience = 5;
  for (int i = 0; i < most && is_exact() && end != Relaxed_scales::End::cancelled; ++i) {
    if (is_met()) break;
    m_scales.meet_few(i >= patience);
  }
  return end;
}

bool Relaxed_positions::is_met()
{
  return !is_exact() || distance() < met;
}

double Relaxed_positions::distance()
{
  m_positions.set_spins(m_scales.spins().lambda());
  return m_positions.distance();
}

Points Relaxed_positions::present_points() const
{
  return (m_anchors ? *m_anchors : m_positions).points_at(m_scales.spins().lambda());
}

Spin_result Relaxed_positions::present(const std::function<void(Spin_result&)>& place)
{
  Spin_result result = m_transformation.surface_of(m_scales.solution(), place);
  if (m_problem.scales.bound) result.report.scales = m_scales.scales();
  return result;
}

}  // namespace Conformal_geometry_processing::internal
