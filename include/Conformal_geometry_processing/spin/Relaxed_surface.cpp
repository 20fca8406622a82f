// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Relaxed_surface.h>

#include <Conformal_geometry_processing/spin/Scale_control.h>

#include <algorithm>
#include <cmath>

namespace Conformal_geometry_processing::internal {

Relaxed_surface::Relaxed_surface(Spin_transformation& transformation, const Eigen::VectorXd& rho,
                                 const Scale_control& control,
                                 const Relaxed_scales_options& options)
    : m_system(transformation.system()),
      m_is_bounded(control.bound.has_value()),
      m_scales(m_system, rho, control, closing(transformation), options)
{}

Relaxed_surface::Relaxed_surface(Dirac_system& system, const Eigen::VectorXd& rho,
                                 const Scale_control& control,
                                 const Relaxed_scales_options& options)
    : m_system(system),
      m_is_bounded(control.bound.has_value()),
      m_scales(m_system, rho, control, {}, options)
{}

double Relaxed_surface::negligible(const Dirac_system& system, const Scale_control& control)
{
  return control.bound && system.is_closed() ? 5e-4 : 0;
}

Spin_residuals Relaxed_surface::closing(Spin_transformation& transformation)
{
  const Exactness_constraints* const loops = transformation.closing();
  if (!loops) return {};
  return {&m_periods.emplace(m_system.surface(), *loops)};
}

void Relaxed_surface::begin_at(const Quaternion_vector<double>& lambda, const Eigen::VectorXd& rho,
                               const Go_further& go_further)
{
  m_scales.restart({lambda, rho, 0, 0});
  m_scales.go_on(go_further);
}

void Relaxed_surface::close()
{
  const int times = 2;
  for (int i = 0; i < times && m_periods && m_scales.steps() > 0; ++i) m_scales.meet_few(false);
}

void Relaxed_surface::close_within_bound(const Go_further& go_further)
{
  const int most_tries = 3;
  for (int i = 0; i <= most_tries; ++i) {
    const double before = m_scales.excess();
    close();
    if (!(m_scales.excess() > 1) || i == most_tries) return;
    m_scales.leave_room(m_scales.excess() - before);
    if (m_scales.go_on(go_further) == Relaxed_scales::End::cancelled) return;
  }
}

Spin_result Relaxed_surface::surface(const Closing_start& start, const Eigen::VectorXd& rho,
                                     const Surface_of& surface_of, const Go_further& go_further)
{
  m_tries = 0, m_asks_for_less = false;
  if (start.is_guided())
    m_scales.run(go_further);
  else
    begin_at(start.lambda, rho, go_further);
  return finished(start.is_guided(), rho, surface_of, go_further);
}

auto Relaxed_surface::position() const -> std::optional<Position>
{
  if (m_asks_for_less) return std::nullopt;
  return Position{m_scales.position(), m_tries, m_stiffness, m_shear_before};
}

Spin_result Relaxed_surface::resumed(const Position& position, const Eigen::VectorXd& rho,
                                     const Surface_of& surface_of, const Go_further& go_further)
{
  m_tries = position.tries;
  m_stiffness = position.stiffness;
  m_shear_before = position.shear;
  m_scales.resume(position.scales, m_stiffness, go_further);
  return finished(true, rho, surface_of, go_further);
}

Spin_result Relaxed_surface::finished(bool is_guided, const Eigen::VectorXd& rho,
                                      const Surface_of& surface_of, const Go_further& go_further)
{
  close_within_bound(go_further);
  Spin_result result = surface_of(m_scales.solution());
  if (is_guided && !is_in_vain(result)) close_up(surface_of, go_further, result);
  if (m_is_bounded && shear(result.report) > 1) ask_for_less(rho, surface_of, go_further, result);
  return result;
}

Spin_report::Scales Relaxed_surface::kept(const Eigen::VectorXd& rho) const
{
  Spin_report::Scales kept = m_scales.scales();
  measure_kept(rho, m_scales.spins().rho(), m_system.areas(), m_system.is_self_adjoint(), kept,
               m_system.part());
  return kept;
}

// How far the edges are from closing up and, within a bound on lengths, the map from being
// conformal, relative to the limits: above 1 the mesh is too coarse for what is wanted.
double Relaxed_surface::shear(const Spin_report& report) const
{
  const Conformality& map = report.conformality;
  const double Q = (std::max)(map.quasi_conformal.mean, map.quasi_conformal_of_new_area);
  const double of_map = (Q - 1) / (report.limits.map.quasi_conformal - 1);
  const double of_edges = report.closure_residual / report.limits.closure;
  return m_is_bounded && of_map > of_edges ? of_map : of_edges;
}

/// by which weights of the misfit leave about so much less shear; steady where it begins to matter
double stiffening(double shear)
{
  const double least = 1.1, most = 3, wanted = .9;
  return std::isfinite(shear) ? std::clamp(std::pow(shear / wanted, 2), least, most) : most;
}

// As much less as there is too much shear, so that the surface changes steadily with rho; soon by
// large parts. Not where that is in vain.
void Relaxed_surface::ask_for_less(const Eigen::VectorXd& rho, const Surface_of& surface_of,
                                   const Go_further& go_further, Spin_result& result)
{
  const double wanted_shear = .95, most_at_once = .7, least = .2;
  const Relaxed_scales::State all = m_scales.state();
  m_asks_for_less = true;
  double share = 1;
  for (int power = 1; !m_scales.is_spent(); power *= 2) {
    share *= (std::max)(most_at_once, std::pow(wanted_shear / shear(result.report), power));
    if (!(share > least)) break;
    m_scales.follow(share * rho, go_further);
    close_within_bound(go_further);
    result = surface_of(m_scales.solution());
    if (result.report.cancelled || shear(result.report) <= 1) return;
  }
  m_scales.restart(all);
  result = surface_of(m_scales.solution());  // with all costs
}

void Relaxed_surface::close_up(const Surface_of& surface_of, const Go_further& go_further,
                               Spin_result& result)
{
  double period_weight = Period_residual::default_weight;
  const int max_tries = 4;
  const double most_shear = .95;
  const auto ends = [&] { return result.report.cancelled || m_scales.is_spent(); };
  while (m_tries < max_tries && !ends()) {
    const bool is_open = !(result.report.period_defect <= result.report.period_limit);
    m_shear_before = shear(result.report);
    if (!is_open && m_shear_before <= most_shear) return;
    if (is_open) m_periods->set_weight(period_weight *= 30);
    const double factor = is_open ? 1 : stiffening(m_shear_before);
    m_stiffness *= factor;
    ++m_tries;
    m_scales.stiffen(factor, go_further);
    close_within_bound(go_further);
    result = surface_of(m_scales.solution());
    if (!is_open && is_in_vain(result)) return;
  }
}

// The last try, if there was one: slivers, say.
bool Relaxed_surface::is_in_vain(const Spin_result& result) const
{
  const double least_gain = .05;
  return m_tries > 0 && !(shear(result.report) < (1 - least_gain) * m_shear_before);
}

}  // namespace Conformal_geometry_processing::internal
