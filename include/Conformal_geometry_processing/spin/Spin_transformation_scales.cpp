// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Transformations with a bound on scales, and those on the exact conformal class.
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <Conformal_geometry_processing/linear_algebra/direct/Stopwatch.h>
#include <Conformal_geometry_processing/spin/Exactness_constraints.h>
#include <Conformal_geometry_processing/spin/Period_limit.h>
#include <Conformal_geometry_processing/spin/Scale_search.h>
#include <Conformal_geometry_processing/spin/Share_search.h>
#include <Conformal_geometry_processing/spin/move_to_class.h>
#include <Conformal_geometry_processing/spin/transformed_edges.h>
#include <Conformal_geometry_processing/threads/Thread_team.h>

#include <cmath>
#include <utility>

namespace Conformal_geometry_processing {

Spin_result Spin_transformation::transform(const Curvature_potential& rho,
                                           const Dirac_options& options,
                                           const internal::Go_further& go_further) &
{
  const internal::Thread_team team;
  m_visits.require_no_visit(m_function);
  require_potential(rho);
  Spin_result result = transform_freely(rho, options, go_further);
  const bool is_found = result.report.converged && !result.report.cancelled;
  if (m_options.exact_conformal_class && is_found)
    result = on_class(std::move(result), rho, options, go_further);
  return judged(std::move(result), rho);
}

Spin_result Spin_transformation::on_class(Spin_result result, const Curvature_potential& rho,
                                          const Dirac_options& options,
                                          const internal::Go_further& go_further)
{
  move_to_class(result);
  const int max_tries = 3;
  internal::Scale_control tighter = m_options.scales;
  for (int i = 0; i < max_tries && result.report.scales.excess() > 1; ++i) {
    const double margin = 1.05;
    tighter.bound = std::pow(*tighter.bound, 1 / (margin * result.report.scales.excess()));
    Spin_result next = bound_scales(rho, 1, tighter, options, go_further);
    if (next.report.converged && !next.report.cancelled) move_to_class(next);
    internal::add_costs(next.report, result.report);
    result = std::move(next);
    if (result.report.cancelled || !result.report.converged) break;
  }
  return result;
}

void Spin_transformation::move_to_class(Spin_result& result)
{
  internal::move_to_class(domain(), m_options.boundary, result);
  Spin_report& r = result.report;
  judge_boundary(domain().frame().to_frame(result.positions), r);
  if (!m_options.scales.bound) return;
  Spin_report::Scales now =
      internal::measured_scales(result.lambda, system().areas(), m_options.scales);
  now.weight = r.scales.weight;
  now.kept_norm = r.scales.kept_norm;
  now.kept_correlation = r.scales.kept_correlation;
  r.scales = now;
}

Spin_result Spin_transformation::transform_freely(const Curvature_potential& rho,
                                                  const Dirac_options& options,
                                                  const internal::Go_further& go_further)
{
  Spin_result result = transform_exactly(rho, options, go_further);
  Spin_report& r = result.report;
  if (!m_options.scales.bound || r.cancelled) return result;
  if (r.converged)  // otherwise lambda may not be finite
    r.scales = internal::measured_scales(result.lambda, system().areas(), m_options.scales);
  const bool is_within = r.converged && r.reached == 1 && r.scales.excess() <= 1;
  const bool is_closed = r.closure_residual <= r.limits.closure;
  if (is_within && is_closed && r.fault() != Spin_report::Fault::map) return result;
  const double share = is_within && is_closed ? .5 : 1;
  Spin_result bounded = bound_scales(rho, share, m_options.scales, options, go_further);
  const bool is_better = !is_within || bounded.report || bounded.report.cancelled;
  Spin_result& best = is_better ? bounded : result;
  internal::add_costs(best.report, is_better ? r : bounded.report);
  return std::move(best);
}

Spin_result Spin_transformation::step_within_bound(const Curvature_potential& rho,
                                                   const Dirac_options& options,
                                                   const internal::Go_further& go_further)
{
  const internal::Scale_control& scales = m_options.scales;
  if (!scales.bound) return trial_step(rho, options, go_further);
  const Eigen::VectorXd& areas = system().areas();
  Spin_result result =
      solve(rho, options, go_further, [&](const Quaternion_vector<double>& lambda) {
        return internal::exceeds_bound_by_far(lambda, areas, scales);
      });
  const Spin_report& r = result.report;
  if (r.converged && !r.cancelled &&
      internal::measured_scales(result.lambda, areas, scales).excess() <= 1)
    reconstruct(result);
  return result;
}

Spin_result Spin_transformation::bound_scales(const Curvature_potential& rho, double share,
                                              const internal::Scale_control& control,
                                              const Dirac_options& options,
                                              const internal::Go_further& go_further)
{
  const auto* const closing = exactness_if_looped(rho.on);
  internal::Stopwatch watch;
  const Poisson_reconstruction& reconstructs = reconstruction();
  m_unreported.seconds.reconstruction += watch.lap();
  using Search = internal::Scale_search;
  Search search(system(), {rho.on, rho.values * domain().unit()}, control, reconstructs, closing,
                [&](const internal::Dirac_solution& found) {
                  return surface_of(found, closing, options.tolerance).report.period_limit;
                });
  using Trial = Search::Trial;
  internal::Share_search<Trial> shares([&](double t, const Trial* from) {
    Spin_result found = surface_of(search.run(t, from, options, m_visits.guarded(go_further)),
                                   closing, options.tolerance);
    if (!found.report.cancelled) found.report.scales = search.scales();
    return typename internal::Share_search<Trial>::Attempt{std::move(found), search.best()};
  });
  Spin_result best = shares.run(share);
  internal::add_costs(best.report, take_unreported());
  return best;
}

Spin_result Spin_transformation::surface_of(internal::Dirac_solution found,
                                            const internal::Exactness_constraints* closing,
                                            double tolerance)
{
  Spin_result result = in_units(std::move(found));
  Spin_report& r = result.report;
  if (r.cancelled) return result;
  reconstruct(result);
  if (!closing) return result;
  r.period_defect = closing->period_defect(transformed_edges(system().surface(), result.lambda));
  r.period_limit = internal::Period_limit{m_options.max_period_defect, tolerance}(r, 1);
  return result;
}

}  // namespace Conformal_geometry_processing
