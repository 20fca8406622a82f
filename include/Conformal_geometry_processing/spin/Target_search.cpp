// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Target_search.h>

#include <Conformal_geometry_processing/spin/Exactness_residual.h>
#include <Conformal_geometry_processing/spin/Period_limit.h>
#include <Conformal_geometry_processing/spin/Position_residual.h>
#include <Conformal_geometry_processing/spin/Potential_search.h>
#include <Conformal_geometry_processing/spin/Scale_search.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Conformal_geometry_processing/spin/boundary_fault.h>
#include <Conformal_geometry_processing/spin/transformed_edges.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// every vertex, with its place in targets
inline std::vector<Control_point> vertices_as_control_points(const Points& targets)
{
  std::vector<Control_point> points;
  for (int v = 0; v < targets.cols(); ++v) points.push_back(control_point(v, targets.col(v)));
  return points;
}

Target_search::Target_search(Transformation& transformation, const Points& targets,
                             const Target_mismatch& mismatch, const Scale_control& scales,
                             Curvature_potential start, const Exactness_constraints* exactness)
    : m_transformation(transformation),
      m_mismatch(mismatch),
      m_control(scales),
      m_areas(transformation.system().areas()),
      m_exactness(exactness),
      m_positions(transformation.system().surface(), transformation.reconstruction(),
                  vertices_as_control_points(targets), m_areas / m_areas.sum()),
      m_inexact(transformation.system().surface(), transformation.reconstruction()),
      m_scales(m_areas, wanted_log_scales(m_areas, scales), scales.weights),
      m_periods(exactness ? std::optional<Period_residual>(
                                {transformation.system().surface(), *exactness})
                          : std::nullopt),
      m_nearest{std::move(start), {}, {}, {}},
      m_search(transformation.system(), m_nearest.rho,
               scales.bound ? std::vector<Spin_residual*>{&m_positions, &m_inexact, &m_scales}
                            : std::vector<Spin_residual*>{&m_positions, &m_inexact},
               exactness ? std::vector<Spin_residual*>{&*m_periods} : std::vector<Spin_residual*>{},
               0.03),
      m_unit(1 / transformation.system().unit()),
      m_last(0),
      m_least(std::numeric_limits<double>::infinity()),
      m_distance(m_least),
      m_normal_distance(m_least)
{
  const double closure_weight = 1000;
  m_positions.set_targets(targets);
  m_inexact.set_weight(closure_weight);
  m_scales.set_weight(m_scale_weight / m_unit);
}

void Target_search::run(const std::optional<Dirac_solution>& start, const Dirac_options& options,
                        const Go_further& go_further)
{
  const double first_weight = 10, last_weight = 2e7, least_factor = 1.3, much_worse = 1.3;
  if (start) restart({m_nearest.rho, *start, {}, {}});
  double factor = 4;
  for (double w = first_weight; w <= last_weight && factor > least_factor && !is_reached();
       w *= factor) {
    const Candidate before = m_search.present();
    if (try_weight(w, options, go_further)) {
      if (m_last > much_worse * m_least) break;
      continue;
    }
    if (m_search.costs().cancelled) break;
    m_search.restore(before);
    w /= factor;
    factor = std::sqrt(factor);
  }
  polish(last_weight, options, go_further);
  m_best.report.cancelled = m_search.costs().cancelled;
  m_best.report.iterations = m_best.report.factorizations = m_best.report.solves = 0;
  static_cast<Dirac_evidence::Seconds&>(m_best.report.seconds) = m_search.costs().seconds;
  add_costs(static_cast<Dirac_evidence&>(m_best.report), m_search.costs());
}

void Target_search::polish(double w, const Dirac_options& options, const Go_further& go_further)
{
  const double reached = 1e-3;
  m_inexact.set_weight(0);  // the target has as much
  for (double before = 2 * reached;
       m_distance < (std::min)(before / 2, reached) && !is_reached();) {
    before = m_distance;
    restart(m_nearest);
    if (!try_weight(w, options, go_further)) return;
  }
}

void Target_search::restart(const Candidate& from)
{
  m_search.restart(from.rho);
  m_search.restore(from);
}

bool Target_search::try_weight(double w, const Dirac_options& options, const Go_further& go_further)
{
  const double period_tolerance = 1e-5, factor = 4, largest_weight = 1e4;
  m_positions.set_weight(w);
  Spin_result next;
  for (;;) {
    m_search.minimize(options, go_further, period_tolerance);
    if (m_search.costs().cancelled) return false;
    next = present();
    if (!(next.report.scales.excess() > 1) || m_scale_weight > largest_weight) break;
    m_scale_weight *= factor;
    m_scales.set_weight(m_scale_weight / m_unit);
  }
  if (!next.report) return false;
  const Target_mismatch::Value mismatch = m_mismatch(next.positions);
  m_last = m_mismatch.sum(mismatch.alignment.rms, mismatch.normals);
  if (!(m_last < m_least)) return m_least > 0;
  m_least = m_last;
  m_distance = mismatch.alignment.rms;
  m_normal_distance = mismatch.normals;
  m_nearest = m_search.present();
  m_best = std::move(next);
  return true;
}

Spin_result Target_search::present()
{
  const auto& system = m_transformation.system();
  const Dirac_solution& s = m_search.present().solution;
  Spin_result result = m_transformation.integrate(s.lambda);
  Spin_report& r = result.report;
  static_cast<Dirac_evidence&>(r) = in_units(s, m_transformation.domain().unit());
  r.converged = s.converged && result.positions.allFinite();
  if (!system.is_closed())
    r.boundary_fault = boundary_fault(
        system.surface(), system.is_self_adjoint() || !system.directions() ? 0 : s.eigenvalue, r);
  if (m_control.bound) r.scales = measured_scales(s.lambda, m_areas, m_control);
  if (m_exactness) {
    r.period_defect = m_exactness->period_defect(transformed_edges(system.surface(), s.lambda));
    r.period_limit = Period_limit()(r, 1);
  }
  return result;
}

}  // namespace Conformal_geometry_processing::internal
