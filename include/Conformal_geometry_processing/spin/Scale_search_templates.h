// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_SCALE_SEARCH_TEMPLATES_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_SCALE_SEARCH_TEMPLATES_H

#include <Conformal_geometry_processing/spin/Exactness_residual_templates.h>
#include <Conformal_geometry_processing/spin/Potential_search_templates.h>
#include <Conformal_geometry_processing/spin/Scale_search.h>

#include <Eigen/Core>

#include <limits>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

inline Eigen::VectorXd wanted_log_scales(const Eigen::VectorXd& areas, const Scale_control& control)
{
  if (control.factors.size() == 0) return Eigen::VectorXd::Zero(areas.size());
  return control.factors.array().log();
}

/// without its mean, where that has no effect
inline Curvature_potential effective(Curvature_potential rho, const Surface_ref& surface,
                                     bool is_closed)
{
  if (is_closed) rho.values.array() -= mean(surface, rho);
  return rho;
}

template <class SolverTraits, class EigensolverTraits>
Scale_search<SolverTraits, EigensolverTraits>::Scale_search(
    Dirac_system<SolverTraits>& system, Curvature_potential rho, const Scale_control& control,
    const Poisson_reconstruction<SolverTraits>& reconstruction,
    const Exactness_constraints* exactness)
    : m_surface(system.surface()),
      m_rho(effective(std::move(rho), m_surface, system.is_closed())),
      m_scales(system.areas(), wanted_log_scales(system.areas(), control), control.weights),
      m_inexact(m_surface, reconstruction),
      m_periods(exactness ? std::optional<Period_residual>({system.surface(), *exactness})
                          : std::nullopt),
      m_search(
          system, m_rho, {&m_scales, &m_inexact},
          exactness ? std::vector<Spin_residual*>{&*m_periods} : std::vector<Spin_residual*>{}),
      m_control(control),
      m_areas(system.areas()),
      m_unit(1 / system.unit()),
      m_best_excess(std::numeric_limits<double>::infinity()),
      m_best_inexact(m_best_excess)
{}

template <class SolverTraits, class EigensolverTraits>
Dirac_solution Scale_search<SolverTraits, EigensolverTraits>::run(const Dirac_options& options,
                                                                  const Go_further& go_further)
{
  const double least_share = 1. / 8;
  for (double share = 1; share >= least_share && !is_found(); share /= 2) {
    if (m_search.costs().cancelled) break;
    m_search.restart({m_rho.on, share * m_rho.values});
    search_weight(options, go_further);
    search_exactness(options, go_further);
  }
  Dirac_solution s = m_best.solution;
  s.cancelled = m_search.costs().cancelled;
  s.iterations = s.factorizations = s.solves = 0;
  s.seconds = m_search.costs().seconds;
  add_costs(s, m_search.costs());
  return s;
}

// The range shrinks slowly with w, like a small power of it.
template <class SolverTraits, class EigensolverTraits>
void Scale_search<SolverTraits, EigensolverTraits>::search_weight(const Dirac_options& options,
                                                                  const Go_further& go_further)
{
  const double first_weight = 10, factor = 4, near_bound = 0.8;
  bool is_minimal = try_weight(first_weight, options, go_further);
  const bool is_within = m_excess <= 1;
  const int max_changes = is_within ? 2 : 5;
  double w = first_weight;
  for (int i = 0; i < max_changes && !m_search.costs().cancelled; ++i) {
    const bool is_enough = is_within ? m_excess > near_bound || !is_minimal : m_excess <= 1;
    if (is_enough) break;
    w = is_within ? w / factor : w * factor;
    is_minimal = try_weight(w, options, go_further);
  }
}

template <class SolverTraits, class EigensolverTraits>
void Scale_search<SolverTraits, EigensolverTraits>::search_exactness(const Dirac_options& options,
                                                                     const Go_further& go_further)
{
  const double first_weight = 0.25, factor = 4;
  const int max_changes = 6;
  double c = first_weight * curvature_areas(m_surface, m_rho.on).dot(m_rho.values.cwiseAbs2());
  for (int i = 0; i < max_changes && m_best_excess <= 1 && !is_found(); ++i) {
    if (m_search.costs().cancelled) break;
    m_inexact.set_weight(c);
    try_weight(m_weight, options, go_further);
    c *= factor;
  }
  m_inexact.set_weight(0);
}

template <class SolverTraits, class EigensolverTraits>
Spin_report::Scales Scale_search<SolverTraits, EigensolverTraits>::scales() const
{
  Spin_report::Scales scales = measured_scales(m_best.solution.lambda, m_areas, m_control);
  scales.weight = m_weight;
  measure_kept(m_rho, m_best.rho, curvature_areas(m_surface, m_rho.on), scales);
  return scales;
}

template <class SolverTraits, class EigensolverTraits>
bool Scale_search<SolverTraits, EigensolverTraits>::try_weight(double w,
                                                               const Dirac_options& options,
                                                               const Go_further& go_further)
{
  const double period_tolerance = 1e-5;
  m_scales.set_weight(w / m_unit);
  const bool is_minimal = m_search.minimize(options, go_further, period_tolerance);
  const typename Search::Candidate& found = m_search.present();
  m_excess = measured_scales(found.solution.lambda, m_areas, m_control).excess();
  if (!is_better(w)) return is_minimal;
  m_best = found;
  m_best_excess = m_excess;
  m_best_inexact = m_inexact.size();
  m_weight = w;
  return is_minimal;
}

template <class SolverTraits, class EigensolverTraits>
bool Scale_search<SolverTraits, EigensolverTraits>::is_better(double w) const
{
  if (m_excess > 1 || m_best_excess > 1) return m_excess < m_best_excess;
  if (m_best_inexact > inexact_limit()) return m_inexact.size() < m_best_inexact;
  return w < m_weight && m_inexact.size() <= inexact_limit();
}

}  // namespace internal
}  // namespace Conformal_geometry_processing

#ifndef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
namespace Conformal_geometry_processing {

extern template class internal::Scale_search<Default_solver_traits, Lobpcg_eigensolver_traits>;

}  // namespace Conformal_geometry_processing
#endif

#endif
