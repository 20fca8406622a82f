// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Relaxed_positions.h>

#include <Conformal_geometry_processing/spin/transformed_edges.h>

#include <algorithm>
#include <utility>

namespace Conformal_geometry_processing::internal {

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
  return positions_of(m_problem.points,
                      m_transformation.reconstruction().positions(transformed_edges(
                          m_transformation.system().surface(), m_scales.spins().lambda())));
}

Spin_result Relaxed_positions::present()
{
  Spin_result result = m_transformation.surface_of(m_scales.solution());
  if (m_problem.scales.bound) result.report.scales = m_scales.scales();
  return result;
}

}  // namespace Conformal_geometry_processing::internal
