// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Transformations with a bound on scales, closed around handles, and on the exact conformal class.
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/spin/Exactness_constraints.h>
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>
#include <Conformal_geometry_processing/spin/Relaxed_surface.h>
#include <Conformal_geometry_processing/spin/snap_to_class.h>
#include <Quaternionic_linear_algebra/direct/Stopwatch.h>
#include <Quaternionic_linear_algebra/threads/Thread_team.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Conformal_geometry_processing {

Spin_result Spin_transformation::transform(const Curvature_potential& rho,
                                           const internal::Go_further& go_further) &&
{
  m_is_last = true;
  return transform(rho, go_further);
}

Spin_result Spin_transformation::transform(const Curvature_potential& rho,
                                           const internal::Go_further& go_further) &
{
  const internal::Thread_team team;
  m_visits.require_no_visit(m_function);
  require_potential(rho);
  Spin_result result =
      is_relaxed() ? relaxed(rho, m_options.scales, 1, go_further) : solve(rho, go_further);
  if (!is_relaxed() && !result.report.cancelled) {
    system().release();  // that of the Laplacian is the only factor then
    reconstruct(result);
    if (m_is_last && !m_options.exact_conformal_class)
      m_stage->poisson.reset();  // another factor of its size judges
  }
  const bool is_found = result.report.converged && !result.report.cancelled;
  if (m_options.exact_conformal_class && is_found)
    result = on_class(std::move(result), rho, go_further);
  return judged(std::move(result), rho);
}

/// \brief a bound with which a surface that was moved to its class is expected to keep to its own:
/// the move adds about the same to the logs of lengths each time.
inline internal::Scale_control tighter_by(const Spin_report& report,
                                          internal::Scale_control control)
{
  const double margin = .05, excess = report.scales.excess();
  if (!(excess > 1)) return control;
  const double now = std::log(*control.bound);
  const double next = now - (excess - 1 + margin) * std::log(report.scales.bound);
  control.bound = std::exp((std::max)(next, now / 4));
  return control;
}

Spin_result Spin_transformation::on_class(Spin_result result, const Curvature_potential& rho,
                                          const internal::Go_further& go_further)
{
  move_to_class(result);
  const int max_tries = 3;
  internal::Scale_control tighter = m_options.scales;
  double stiffness = 1;
  const auto is_there = [&] {
    const Spin_report& r = result.report;
    return !is_relaxed() || (r.scales.excess() <= 1 && r.exact_class && *r.exact_class);
  };
  for (int i = 0; i < max_tries && !is_there(); ++i) {
    if (!*result.report.exact_class) stiffness *= 10;  // nearer to the class
    tighter = tighter_by(result.report, tighter);
    Spin_result next = relaxed(rho, tighter, stiffness, go_further);
    if (next.report.converged && !next.report.cancelled) move_to_class(next);
    internal::add_costs(next.report, result.report);
    result = std::move(next);
    const Spin_report& r = result.report;
    if (r.cancelled || !r.converged || r.is_unfinished) break;
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

Spin_result Spin_transformation::relaxed(const Curvature_potential& rho,
                                         const internal::Scale_control& control, double stiffness,
                                         const internal::Go_further& go_further)
{
  const Eigen::VectorXd wanted = in_frame(rho);
  const internal::Closing_start start = closing_start(wanted, go_further);
  internal::Relaxed_scales_options search_options;
  if (!start.is_guided() && !control.bound) search_options = internal::Closing_start::few_steps();
  search_options.spins.weights.factor = stiffness;
  if (!m_options.exact_conformal_class)  // told from a class nearby
    search_options.spins.negligible = internal::Relaxed_surface::negligible(system(), control);
  internal::Relaxed_surface search(*this, wanted, control, search_options);
  const auto integrated = [this](internal::Dirac_solution found) {
    // The factor of the Laplacian takes the place of that of X, which is made anew in the rare case
    // that the search goes on.
    if (m_is_last && !has_loops()) system().release();
    return surface_of(std::move(found));
  };
  Spin_result result = search.surface(start, wanted, integrated, m_visits.guarded(go_further));
  if (!result.report.cancelled) tell_shares(search, wanted, control, result.report);
  auto& fault = result.report.boundary_fault;
  if (start.is_ambiguous && fault == Spin_report::Boundary_fault::none)
    fault = Spin_report::Boundary_fault::ambiguous;
  internal::add_costs(result.report, take_unreported());
  return result;
}

Spin_result Spin_transformation::preview(const Curvature_potential& rho, bool continues)
{
  if (!is_relaxed()) return transform(rho);
  const internal::Thread_team team;
  m_visits.require_no_visit(m_function);
  require_potential(rho);
  const Eigen::VectorXd wanted = in_frame(rho);
  auto& search = m_stage->preview;
  internal::Relaxed_scales_options few;
  few.max_steps = 6;
  if (!search || !continues)
    search = std::make_shared<internal::Relaxed_surface>(*this, wanted, m_options.scales, few);
  internal::Relaxed_scales& scales = search->scales();
  scales.reset_costs();
  scales.renew_budget();
  if (continues && scales.steps() > 0)
    scales.follow(wanted);
  else
    scales.run();
  search->close();
  Spin_result result = surface_of(scales.solution());
  tell_shares(*search, wanted, m_options.scales, result.report);
  internal::add_costs(result.report, take_unreported());
  return judged(std::move(result), rho);
}

Eigen::VectorXd Spin_transformation::in_frame(const Curvature_potential& rho) const
{
  return domain().unit() * internal::values_at_vertices(domain().mesh(), rho);
}

void Spin_transformation::tell_shares(const internal::Relaxed_surface& found,
                                      const Eigen::VectorXd& wanted,
                                      const internal::Scale_control& control, Spin_report& report)
{
  const Spin_report::Scales kept = found.kept(wanted);
  const Eigen::VectorXd added = found.scales().spins().rho() - wanted;
  report.eigenvalue = system().mean(added) / domain().unit();
  if (control.bound) report.scales = kept;
  if (!closing()) return;
  if (turns_directions()) {
    const double sphere = std::sqrt(4 * std::acos(-1.));
    report.added_share = std::sqrt(system().areas().dot(added.cwiseAbs2())) / sphere;
  } else {
    report.missing_share = kept.distance();
    const double left_out = (std::min)(kept.distance(), 1.);
    report.realised_share = std::sqrt(1 - left_out * left_out);
  }
}

Spin_result Spin_transformation::closed_step(const Eigen::VectorXd& rho,
                                             const internal::Go_further& go_further)
{
  using On = Curvature_potential::On;
  const internal::Thread_team team;
  if (has_loops()) (void)exactness(On::vertices);  // first, because it needs another factor
  Spin_result result = trial_step({On::vertices, rho}, go_further);
  const Spin_report& r = result.report;
  if (r.cancelled || !has_loops()) return result;
  judge_periods(exactness(On::vertices), result);
  const double limit = period_limit(r);
  if (m_options.exactness && r.converged && r.period_defect > limit) close(rho, limit, result);
  return result;
}

void Spin_transformation::close(const Eigen::VectorXd& rho, double limit, Spin_result& result)
{
  internal::Stopwatch watch;
  Spin_report& r = result.report;
  const double gamma = system().is_self_adjoint() ? r.eigenvalue : 0;
  internal::Closed_spins closed = internal::closed_spins(
      system(), exactness(Curvature_potential::On::vertices),
      domain().unit() * (rho.array() + gamma).matrix(), std::move(result.lambda), limit);
  result.lambda = system().normalized(std::move(closed.lambda));
  r.period_defect = closed.period_defect;
  r.solves += closed.solves;
  judge_equation(std::move(closed.rho), result);
  r.seconds.exactness += watch.lap();
  reconstruct(result);
}

void Spin_transformation::judge_equation(Eigen::VectorXd rho, Spin_result& result) const
{
  const Surface_ref& surface = system().surface();
  Spin_report& r = result.report;
  const auto changed = [&] { return Curvature_potential::on_vertices(rho); };
  if (system().is_self_adjoint()) {
    const double gamma = dirac_quotient(surface, changed(), result.lambda);
    r.eigenvalue += gamma / domain().unit();
    rho.array() += gamma;
  }
  const double misfit = dirac_misfit(surface, changed(), result.lambda) / domain().unit();
  (system().is_self_adjoint() ? r.dirac_residual : r.eigenvalue) = misfit;
}

void Spin_transformation::judge_periods(const internal::Exactness_constraints& closing,
                                        Spin_result& result) const
{
  result.report.period_defect =
      closing.period_defect(transformed_edges(system().surface(), result.lambda));
}

double Spin_transformation::period_limit(const Spin_report& report) const
{
  return internal::Period_limit{m_options.max_period_defect, m_options.dirac.tolerance}(report);
}

Spin_result Spin_transformation::surface_of(internal::Dirac_solution found,
                                            const std::function<void(Spin_result&)>& place)
{
  Spin_result result = in_units(std::move(found));
  if (result.report.cancelled) return result;
  const internal::Exactness_constraints* const loops = closing();
  if (loops) judge_periods(*loops, result);
  reconstruct(result, place);
  Spin_report& r = result.report;
  r.converged = r.converged && result.positions.allFinite();
  if (loops) r.period_limit = period_limit(r);
  return result;
}

}  // namespace Conformal_geometry_processing
