// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Scale_search.h>

#include <Conformal_geometry_processing/spin/Exactness_residual.h>
#include <Conformal_geometry_processing/spin/Potential_search.h>

#include <Eigen/Core>

#include <cmath>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// without its mean, where that has no effect
inline Curvature_potential effective(Curvature_potential rho, const Surface_ref& surface,
                                     bool is_closed)
{
  if (is_closed) rho.values.array() -= mean(surface, rho);
  return rho;
}

Scale_search::Scale_search(Dirac_system& system, Curvature_potential rho,
                           const Scale_control& control,
                           const Poisson_reconstruction& reconstruction,
                           const Exactness_constraints* exactness, Limit_of_periods period_limit)
    : m_surface(system.surface()),
      m_is_closed(system.is_closed()),
      m_rho(effective(std::move(rho), m_surface, m_is_closed)),
      m_scales(system.areas(), wanted_log_scales(system.areas(), control), control.weights),
      m_inexact(m_surface, reconstruction),
      m_periods(exactness ? std::optional<Period_residual>({system.surface(), *exactness})
                          : std::nullopt),
      m_search(
          system, m_rho, {&m_scales, &m_inexact},
          exactness ? std::vector<Spin_residual*>{&*m_periods} : std::vector<Spin_residual*>{}),
      m_control(control),
      m_period_limit(std::move(period_limit)),
      m_areas(system.areas()),
      m_unit(1 / system.unit())
{}

Dirac_solution Scale_search::run(double share, const Trial* from, const Dirac_options& options,
                                 const Go_further& go_further)
{
  double first_weight = 10;
  m_wanted = share * m_rho.values;
  m_search.restart({m_rho.on, m_wanted});
  if (from) {
    m_search.restore(from->candidate);
    m_inexact.set_weight(from->exactness_weight);
    first_weight = from->weight;
  }
  m_search.reset_costs();
  m_best = m_beyond = Trial();
  search_weight(first_weight, options, go_further);
  search_exactness(options, go_further);
  come_up_to_bound(options, go_further);
  m_inexact.set_weight(0);
  Dirac_solution s = m_best.candidate.solution;
  s.cancelled = m_search.costs().cancelled;
  s.iterations = s.factorizations = s.solves = 0;
  s.seconds = m_search.costs().seconds;
  add_costs(s, m_search.costs());
  return s;
}

// The range shrinks slowly with w, like a small power of it.
void Scale_search::search_weight(double first, const Dirac_options& options,
                                 const Go_further& go_further)
{
  const double factor = 4, near_bound = 0.95;
  bool is_minimal = try_weight(first, options, go_further);
  const bool is_within = m_last.excess <= 1;
  const int max_changes = is_within ? 4 : 5;
  double w = first;
  for (int i = 0; i < max_changes && !m_search.costs().cancelled; ++i) {
    const bool is_enough =
        is_within ? m_last.excess > near_bound || !is_minimal : m_last.excess <= 1;
    if (is_enough) break;
    w = is_within ? w / factor : w * factor;
    const Eigen::VectorXd before = m_search.present().rho.values;
    is_minimal = try_weight(w, options, go_further);
    // Where the spins follow no step, a larger weight asks for nearly the same ones.
    if (!is_minimal && m_search.present().rho.values == before) break;
  }
}

void Scale_search::search_exactness(const Dirac_options& options, const Go_further& go_further)
{
  const double first_weight = 0.25, factor = 4;
  const int max_changes = 6;
  double c = first_weight * curvature_areas(m_surface, m_rho.on).dot(m_rho.values.cwiseAbs2());
  for (int i = 0; i < max_changes && m_best.excess <= 1 && !is_found(); ++i) {
    if (m_search.costs().cancelled) break;
    m_inexact.set_weight(c);
    try_weight(m_best.weight, options, go_further);
    c *= factor;
  }
}

void Scale_search::come_up_to_bound(const Dirac_options& options, const Go_further& go_further)
{
  const double near_bound = 0.95, aim = 0.98;
  const int max_tries = 6;
  double stride = 1. / 8;  // towards rho
  for (int i = 0; i < max_tries && is_found() && m_best.reach() < near_bound; ++i) {
    if (m_search.costs().cancelled) break;
    const double below = m_best.reach(), above = m_beyond.reach();
    if (!is_any_beyond()) {
      if (m_periods) break;  // which would open on the way
      move_between(stride, options, go_further);
      if (m_best.reach() == below && !is_any_beyond()) stride /= 4;
      continue;
    }
    const double t = (aim - below) / (above - below);
    const bool has_moved = move_between(t, options, go_further);
    if (!has_moved && m_beyond.weight != m_best.weight) minimize_between(t, options, go_further);
    if (m_best.reach() == below && m_beyond.reach() == above) break;
  }
}

Spin_report::Scales Scale_search::scales() const
{
  Spin_report::Scales scales =
      measured_scales(m_best.candidate.solution.lambda, m_areas, m_control);
  scales.weight = m_best.weight;
  measure_kept(m_rho, m_best.candidate.rho, curvature_areas(m_surface, m_rho.on), m_is_closed,
               scales);
  return scales;
}

bool Scale_search::try_weight(double w, const Dirac_options& options, const Go_further& go_further)
{
  m_scales.set_weight(w / m_unit);
  const bool is_minimal = m_search.minimize(options, go_further, period_tolerance);
  judge(w);
  return is_minimal;
}

bool Scale_search::move_between(double t, const Dirac_options& options,
                                const Go_further& go_further)
{
  const Curvature_potential& here = m_best.candidate.rho;
  const Eigen::VectorXd& there = is_any_beyond() ? m_beyond.candidate.rho.values : m_wanted;
  const Eigen::VectorXd rho = (1 - t) * here.values + t * there;
  const auto& closest = (t < 0.5 || !is_any_beyond() ? m_best : m_beyond).candidate;
  const double w = weight_between(t), above = m_beyond.reach();
  if (m_search.present().rho.values != closest.rho.values) m_search.restore(closest);
  if (!m_search.move_to({here.on, rho}, options, go_further)) return false;
  if (m_search.present().constraints.norm() > period_tolerance)
    try_weight(w, options, go_further);
  else
    judge(w);
  return m_last.reach() < above;
}

void Scale_search::minimize_between(double t, const Dirac_options& options,
                                    const Go_further& go_further)
{
  const double w = weight_between(t);
  m_search.restore(m_best.candidate);
  try_weight(w, options, go_further);
}

double Scale_search::openness(const Search::Candidate& found) const
{
  const double defect = found.constraints.norm();
  return defect <= period_tolerance ? 0 : defect / m_period_limit(found.solution);
}

void Scale_search::judge(double w)
{
  const Search::Candidate& found = m_search.present();
  m_inexact.set_spins(found.solution.lambda);  // the search may have tried others after it
  m_last = {found,
            w,
            m_inexact.weight(),
            measured_scales(found.solution.lambda, m_areas, m_control).excess(),
            m_inexact.size(),
            openness(found)};
  if (m_last.reach() > 1 && m_last.reach() < m_beyond.reach()) m_beyond = m_last;
  if (is_better(m_last)) m_best = m_last;
}

bool Scale_search::is_better(const Trial& trial) const
{
  if (trial.excess > 1 || m_best.excess > 1) return trial.excess < m_best.excess;
  if (m_best.inexact > inexact_limit()) return trial.inexact < m_best.inexact;
  if (trial.inexact > inexact_limit()) return false;
  if (m_best.open > 1) return trial.open < m_best.open;
  return trial.open <= 1 && trial.distance() < m_best.distance();
}

}  // namespace Conformal_geometry_processing::internal
