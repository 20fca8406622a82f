// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Relaxed_scales.h>

#include <Conformal_geometry_processing/operators/dirac_energy.h>

#include <cmath>
#include <utility>

namespace Conformal_geometry_processing::internal {

Spin_residuals with_scales(Spin_residuals others, Scale_residual& scales, bool is_bounded)
{
  if (is_bounded) others.push_back(&scales);
  return others;
}

/// without its mean, where that has no effect
Eigen::VectorXd effective(Eigen::VectorXd rho, const Dirac_system& system)
{
  if (system.is_self_adjoint()) rho.array() -= system.mean(rho);
  return rho;
}

Relaxed_scales::Relaxed_scales(Dirac_system& system, const Eigen::VectorXd& rho,
                               const Scale_control& control, Spin_residuals others,
                               const Relaxed_scales_options& options)
    : m_system(system),
      m_control(control),
      m_options(options),
      m_rho(effective(rho, system)),
      m_scales(system.areas(), wanted_log_scales(system.areas(), control), control.weights,
               system.part()),
      m_spins(system, m_rho, with_scales(std::move(others), m_scales, is_bounded()), options.spins)
{}

/// a zero of f between 0 and an end, or the end if there is none: by false positions
template <class Function>
double root_beyond(const Function& f, double at_zero, double end)
{
  const int most = 6;
  const double least = 1e-3 * std::abs(at_zero);
  double a = 0, fa = at_zero, b = end, fb = f(end);
  for (int i = 0; i < most && fa * fb < 0 && std::abs(fb) > least; ++i) {
    const double c = b - fb * (b - a) / (fb - fa), fc = f(c);
    if (fc * fb < 0)
      a = b, fa = fb;
    else
      fa /= 2;  // or one end would never move
    b = c, fb = fc;
  }
  return b;
}

void Relaxed_scales::set_weight(double weight)
{
  m_weight = weight;
  m_scales.set_weight(weight * m_system.unit());
}

double Relaxed_scales::excess_of(const Relaxed_spins::Spins& lambda) const
{
  return measured_scales(lambda, m_system.areas(), m_control, m_system.part()).excess();
}

// At the spins where a step begins; none where the bound is far.
Relaxed_spins::Unknown Relaxed_scales::log_weight()
{
  const double slack = .8;
  if (!is_bounded() || (m_weight <= m_options.least_weight && m_excess < slack)) return {};
  m_scales.set_spins(m_spins.lambda());
  return {
      -1. * m_scales.gradient(m_scales.values()), m_response,
      [this](const auto& there, const auto& response) { return place_weight(there, response); }};
}

// The change of log w with which lengths are just within the bound.
double Relaxed_scales::place_weight(const Relaxed_spins::Spins& there,
                                    const Relaxed_spins::Spins& response)
{
  const double aim = 1 - m_room - m_options.closeness / 2, tolerance = m_options.closeness / 8;
  const double most = std::log(4.), trusted = 1;
  const auto level = [&](double t) {
    return std::log((std::max)(excess_of(there + t * response), .1) / aim);
  };
  const double least = (std::max)(std::log(m_options.least_weight / m_weight), -most);
  const double here = level(0);
  const double t =
      std::abs(here) < tolerance ? 0 : root_beyond(level, here, here > 0 ? most : least);
  m_response = std::abs(t) < trusted ? response : Relaxed_spins::Spins();
  set_weight(m_weight * std::exp(t));
  return t;
}

auto Relaxed_scales::step(double share, const Go_further& go_further,
                          const Relaxed_spins::Unknown& unknown) -> End
{
  m_spins.want(share * m_rho);
  const Relaxed_spins::Progress progress = m_spins.advance(
      [&] {
        ++m_spent;
        return go_further({++m_iterations, m_excess, m_moved});
      },
      unknown);
  if (progress.cancelled) return End::cancelled;
  if (progress.length < 1) m_response.resize(0);  // it may be what leads astray
  ++m_steps;
  m_moved = progress.moved;
  m_way += m_moved;
  m_gain = (progress.before - progress.after) / progress.after;
  m_excess = excess_of(m_spins.lambda());
  return progress.length > 0 ? End::settled : End::no_descent;
}

// A part of rho tells what all of it would do, as logs of lengths are nearly linear in it. The
// power and its factor are those of scans: a weight that is far too small costs steps.
void Relaxed_scales::guess_weight(double share)
{
  const double expected = m_excess / share;
  const double most = 30, least_change = .5, most_change = 8;
  const double guess = m_steps == 1
                           ? (std::min)(.1 * std::pow(expected, 2.25), most)
                           : m_weight * std::clamp(expected * expected, least_change, most_change);
  set_weight((std::max)(guess, m_options.least_weight));
}

auto Relaxed_scales::position() const -> Position
{
  return {state(), m_best, m_response, m_spins.factored(), m_way, m_room, m_steps, m_spent};
}

auto Relaxed_scales::resume(const Position& position, double factor, const Go_further& go_further)
    -> End
{
  m_spins.stiffen(factor);
  restart(position.state);
  m_spins.factorize_at(position.factored);
  m_best = position.best;
  m_response = position.response;
  m_way = position.way;
  m_room = position.room;
  m_steps = position.steps;
  m_spent = position.spent;
  return m_end = settle(go_further);
}

auto Relaxed_scales::run(const Go_further& go_further, const Ask& ask) -> End
{
  m_best.reset();
  set_weight(is_bounded() ? m_options.least_weight : 0);
  m_way = 0;
  m_steps = 0;
  m_response.resize(0);
  m_spins.restart(m_spins.start(), m_rho / m_options.stages);
  m_end = go_up(go_further, ask);
  if (m_end != End::cancelled) m_end = settle(go_further);
  return m_end;
}

auto Relaxed_scales::follow(const Eigen::VectorXd& rho, const Go_further& go_further) -> End
{
  m_rho = effective(rho, m_system);
  return go_on(go_further);
}

auto Relaxed_scales::stiffen(double factor, const Go_further& go_further) -> End
{
  m_spins.stiffen(factor);
  return go_on(go_further);
}

auto Relaxed_scales::go_on(const Go_further& go_further) -> End
{
  if (is_bounded()) set_weight((std::max)(m_weight, m_options.least_weight));
  m_best.reset();
  m_steps = 0;
  m_response.resize(0);
  return m_end = settle(go_further);
}

auto Relaxed_scales::go_up(const Go_further& go_further, const Ask& ask) -> End
{
  for (int i = 1; i <= m_options.stages; ++i) {
    const double share = 1. * i / m_options.stages;
    if (ask) ask(share);
    if (i == m_options.stages) return End::settled;  // `settle()` makes the last ones
    if (const End end = step(share, go_further); end == End::cancelled) return end;
    if (is_bounded()) guess_weight(share);
  }
  return End::settled;
}

auto Relaxed_scales::settle(const Go_further& go_further) -> End
{
  m_spins.set_tolerance(m_options.last_tolerance);
  while (m_steps < m_options.max_steps && !is_spent()) {
    m_options.between_steps();
    const End end = step(1, go_further, log_weight());
    if (end == End::cancelled) return end;
    const bool is_met = m_options.is_met();
    if (is_met) keep_if_within();
    const bool is_settled =
        (is_met && m_gain < m_options.least_gain && m_moved < m_options.settled * m_way) ||
        end == End::no_descent;
    const double most = 1 - m_room;
    const bool is_slack = !is_bounded() || (m_excess < most && m_weight <= m_options.least_weight);
    if (is_settled && is_slack) return End::settled;
    if (is_settled && m_excess <= most && m_excess >= most - m_options.closeness)
      return End::within_bound;
  }
  take_best();
  return End::too_many_steps;
}

void Relaxed_scales::keep_if_within()
{
  if (is_bounded() && m_excess <= 1 - m_room) m_best = state();
}

void Relaxed_scales::take_best()
{
  if (m_best) restart(*m_best);
}

void Relaxed_scales::meet_few(bool is_anew)
{
  m_spins.meet_few(is_anew);
  m_excess = excess_of(m_spins.lambda());
}

void Relaxed_scales::restart(const State& state)
{
  m_spins.restart(state.lambda, state.rho);
  set_weight(state.weight);
  m_excess = state.excess;
}

Dirac_solution Relaxed_scales::solution() const
{
  const Relaxed_costs& costs = m_spins.costs();
  Dirac_solution s;
  s.lambda = m_system.normalized(m_spins.lambda());
  s.is_relaxed = true;
  s.is_unfinished = is_spent();
  s.cancelled = m_end == End::cancelled;
  s.converged = !s.cancelled && m_system.part().sum(components(s.lambda).allFinite() ? 0 : 1) == 0;
  s.eigenvalue = m_system.mean(m_spins.rho() - m_rho);
  s.dirac_residual =
      dirac_misfit(m_system.surface(), Curvature_potential::on_vertices(m_spins.rho()), s.lambda,
                   m_system.part());
  s.overlap = m_system.overlap_with_identity(s.lambda);
  s.iterations = m_iterations;
  s.factorizations = costs.factorizations;
  s.solves = costs.solves + costs.block_columns;
  s.seconds = costs.seconds;
  return s;
}

Spin_report::Scales Relaxed_scales::scales() const
{
  Spin_report::Scales scales =
      measured_scales(m_spins.lambda(), m_system.areas(), m_control, m_system.part());
  scales.weight = m_weight > m_options.least_weight ? m_weight : 0;
  measure_kept(m_rho, m_spins.rho(), m_system.areas(), m_system.is_self_adjoint(), scales,
               m_system.part());
  return scales;
}

}  // namespace Conformal_geometry_processing::internal
