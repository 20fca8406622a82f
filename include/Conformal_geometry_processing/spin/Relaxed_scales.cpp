// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Relaxed_scales.h>

#include <Conformal_geometry_processing/spin/Scale_control.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace Conformal_geometry_processing::internal {

Relaxed_scales::Relaxed_scales(Dirac_system& system, const Curvature_potential& rho,
                               const Scale_control& control, const Options& options)
    : m_system(system),
      m_control(control),
      m_options(options),
      m_rho(rho.values),
      m_scales(system.areas(), wanted_log_scales(system.areas(), control), control.weights),
      m_spins(system, rho, {&m_scales}, options.spins),
      m_weight(options.first_weight)
{
  if (system.is_closed()) m_rho.array() -= mean(system.surface(), rho);
}

bool Relaxed_scales::step(double share, const Watch& watch)
{
  m_scales.set_weight(m_weight * m_system.unit());
  m_spins.want(share * m_rho);
  const Relaxed_spins::Progress progress = m_spins.advance();
  ++m_steps;
  m_moved = progress.moved;
  m_excess = measured_scales(m_spins.lambda(), m_system.areas(), m_control).excess();
  if (watch) watch(*this, progress);
  return progress.length > 0;
}

// The excess falls like a power of w that is not known, and follows w a step late, so that secants
// through two steps lead astray: changes become smaller where the bound is passed, and larger where
// it is not.
void Relaxed_scales::change_weight()
{
  const double aim = 1 - m_options.closeness / 2;
  const double level = std::log((std::max)(m_excess, .1) / aim);
  if (level * m_last_level < 0)
    m_rate = (std::max)(1.5 * m_rate, -1.5);
  else if (m_last_level != 0 && m_moved < m_options.settled)
    m_rate = (std::min)(.7 * m_rate, -.05);
  m_last_level = level;
  m_weight *= std::exp(std::clamp(-level / m_rate, std::log(1. / 6), std::log(4.)));
}

auto Relaxed_scales::run(const Watch& watch) -> End
{
  m_spins.restart(Quaternion_vector<double>::Constant(m_system.areas().size(), {1, 0, 0, 0}),
                  m_rho / m_options.stages);
  for (int i = 1; i < m_options.stages; ++i) step(1. * i / m_options.stages, watch);
  m_excess *= 1. * m_options.stages / (m_options.stages - 1);  // expected after the last stage
  change_weight();
  m_last_level = 0;
  m_spins.set_tolerance(m_options.last_tolerance);
  while (m_steps < m_options.max_steps) {
    if (!step(1, watch)) return End::no_descent;
    const bool is_settled = m_moved < m_options.settled;
    const bool is_within = m_excess <= 1 && m_excess >= 1 - m_options.closeness;
    if (is_settled && is_within) return End::within_bound;
    if (is_settled && m_excess < 1 && m_weight <= m_options.least_weight)
      return End::bound_is_slack;
    change_weight();
  }
  return End::too_many_steps;
}

}  // namespace Conformal_geometry_processing::internal
