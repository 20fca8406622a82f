// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Control_point_search.h>

#include <Conformal_geometry_processing/spin/Position_residual.h>
#include <Conformal_geometry_processing/spin/Potential_search.h>
#include <Conformal_geometry_processing/spin/Scale_search.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Conformal_geometry_processing/spin/transformed_edges.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing::internal {

Control_point_search::Control_point_search(Transformation& transformation,
                                           std::vector<Control_point> points,
                                           const Conformal_deformation_options& options)
    : m_transformation(transformation),
      m_options(options),
      m_exactness(transformation.exactness_if_looped(Curvature_potential::On::vertices)),
      m_points(std::move(points)),
      m_positions(transformation.system().surface(), transformation.reconstruction(), m_points),
      m_scales(transformation.system().areas(),
               wanted_log_scales(transformation.system().areas(), options.surface.scales),
               options.surface.scales.weights),
      m_unit(1 / transformation.system().unit())
{
  std::vector<Spin_residual*> residuals, constraints;
  const double w = options.position_weight;
  if (std::isfinite(w)) m_positions.set_weight(w * w);
  (std::isfinite(w) ? residuals : constraints).push_back(&m_positions);
  if (m_exactness) m_periods.emplace(transformation.system().surface(), *m_exactness);
  if (m_exactness) constraints.push_back(&*m_periods);
  if (options.surface.scales.bound) residuals.push_back(&m_scales);
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(transformation.system().areas().size());
  m_search.emplace(transformation.system(), Curvature_potential::on_vertices(none), residuals,
                   constraints);
}

bool Control_point_search::is_for(const std::vector<Control_point>& points) const
{
  const auto is_same = [](const Control_point& a, const Control_point& b) {
    return a.vertices == b.vertices && a.weights == b.weights;
  };
  return std::equal(points.begin(), points.end(), m_points.begin(), m_points.end(), is_same);
}

Points Control_point_search::present_points() const
{
  const Quaternion_vector<double>& lambda = m_search->present().solution.lambda;
  return positions_of(m_points, m_transformation.reconstruction().positions(transformed_edges(
                                    m_transformation.system().surface(), lambda)));
}

void Control_point_search::set_targets(const Points& targets)
{
  m_from = present_points();
  const Alignment a = placement(m_from, targets);
  m_to = a.rotation.transpose() * (targets.colwise() - a.translation) / a.scale;
}

void Control_point_search::run(const Points& targets, const Dirac_options& options,
                               const Go_further& go_further)
{
  m_search->reset_costs();
  set_targets(targets);
  go(options, go_further);
  if (!m_has_run || m_reached == 1 || m_search->costs().cancelled) {
    m_has_run = true;
    return;
  }
  const Eigen::Index size = m_search->present().rho.values.size();
  m_search->restart(Curvature_potential::on_vertices(Eigen::VectorXd::Zero(size)));
  set_targets(targets);
  go(options, go_further);
}

void Control_point_search::go(const Dirac_options& options, const Go_further& go_further)
{
  const double first_weight = 1;
  m_weight = first_weight;
  m_scales.set_weight(m_weight / m_unit);
  m_reached = 0;
  m_steps = 0;
  for (double step = 1; m_reached < 1 && step >= m_options.min_step;) {
    const double rest = 1 - m_reached - step;
    const bool is_there = go_to(rest < m_options.min_step ? 1 : 1 - rest, options, go_further);
    if (m_search->costs().cancelled) return;
    if (!is_there) step /= 2;
  }
  if (m_options.surface.scales.bound) bound_scales(options, go_further);
}

bool Control_point_search::go_to(double share, const Dirac_options& options,
                                 const Go_further& go_further)
{
  const double tolerance = 1e-9;  // of distances by R
  const Search::Candidate before = m_search->present();
  m_positions.set_targets(m_from + share * (m_to - m_from));
  const auto is_there = [&] {
    return m_search->follow_constraints(options, go_further, tolerance) ||
           m_search->minimize(options, go_further, tolerance);
  };
  if (is_there() && is_good()) {
    m_reached = share;
    ++m_steps;
    return true;
  }
  m_search->restore(before);
  return false;
}

bool Control_point_search::is_good() const
{
  const Spin_report report = m_transformation.integrate(m_search->present().solution.lambda).report;
  return report && report.conformality.flipped_faces == 0;
}

void Control_point_search::bound_scales(const Dirac_options& options, const Go_further& go_further)
{
  const double factor = 4, largest_weight = 1e3;
  while (scales().excess() > 1 && m_weight < largest_weight) {
    m_scales.set_weight(factor * m_weight / m_unit);
    if (!go_to(m_reached, options, go_further)) return;
    m_weight *= factor;
  }
}

Spin_report::Scales Control_point_search::scales() const
{
  Spin_report::Scales scales =
      measured_scales(m_search->present().solution.lambda, m_transformation.system().areas(),
                      m_options.surface.scales);
  scales.weight = m_weight;
  return scales;
}

double Control_point_search::period_defect() const
{
  if (!m_exactness) return 0;
  return m_exactness->period_defect(
      transformed_edges(m_transformation.system().surface(), m_search->present().solution.lambda));
}

}  // namespace Conformal_geometry_processing::internal
