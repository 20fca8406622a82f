// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Potential_search.h>

#include <Conformal_geometry_processing/spin/solve_dirac_equation.h>

#include <Eigen/Core>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// Spins that take more iterations are too far from the predicted ones, or near a crossing of
/// branches.
inline Dirac_options limited(Dirac_options options)
{
  options.max_iterations = (std::min)(options.max_iterations, 40);
  return options;
}

Potential_search::Potential_search(Dirac_system& system, Curvature_potential rho,
                                   std::vector<Spin_residual*> residuals,
                                   std::vector<Spin_residual*> constraints, double smoothness)
    : m_system(system),
      m_rho(std::move(rho)),
      m_residuals(std::move(residuals)),
      m_constraints(std::move(constraints)),
      m_metric(system, m_rho.on, smoothness / system.unit())
{
  restart(m_rho);
}

void Potential_search::restart(Curvature_potential rho)
{
  m_rho = std::move(rho);
  m_now = Candidate();
  m_now.rho = {m_rho.on, Eigen::VectorXd::Zero(m_rho.values.size())};
  m_now.solution.lambda = Spins::Constant(m_system.areas().size(), {1, 0, 0, 0});
  m_factored_at = -1;
  m_last_constraints.reset();
}

bool Potential_search::minimize(const Dirac_options& options, const Go_further& go_further,
                                double tolerance)
{
  const int max_steps = 40;
  const Dirac_options few = limited(options);
  m_last_length = 1;
  m_penalty = 0;
  refresh(few, go_further);
  double last_norm = 0;
  int creeping = 0;
  for (int i = 0; i < max_steps && !m_costs.cancelled; ++i) {
    const std::optional<Step> step = best_step();
    if (!step) return false;
    const double norm = m_now.constraints.norm();
    // Where a step only corrects, and the last one left a tenth, its gradients do until the end.
    const auto follows = [&] { return follow_constraints(few, go_further, tolerance); };
    const bool is_near = norm <= last_norm / 10;
    if (!step->is_improvement && (norm <= tolerance || (is_near && follows()))) return true;
    const double sum = m_now.sum;
    if (!take(*step, few, go_further)) return false;
    const bool stays_within = norm <= tolerance && m_now.constraints.norm() <= tolerance;
    creeping = stays_within && m_now.sum > (1 - 2 * least_gain) * sum ? creeping + 1 : 0;
    if (creeping == 2) return m_last_length > shortest;  // one such step may lead to a longer one
    last_norm = norm;
  }
  return false;
}

bool Potential_search::follow_constraints(const Dirac_options& options,
                                          const Go_further& go_further, double tolerance)
{
  const double least_reduction = 0.1;
  if (!m_last_constraints || !m_residuals.empty()) return false;
  // What is learned on the way is not kept: the first step shall tell how well the gradients still
  // hold, or the sum would grow from call to call.
  Linear_constraints constraints = *m_last_constraints;
  refresh(options, go_further);
  if (constraints.size() != m_now.constraints.size()) return false;
  const Candidate before = m_now;
  while (m_now.solution.converged && m_now.constraints.norm() > tolerance) {
    const Eigen::VectorXd c = m_now.constraints;
    Step step;
    step.change = constraints.least_solution(-c);
    if (!predict(step)) break;
    m_now = moved(step, options, go_further);
    if (!(m_now.constraints.norm() <= (std::max)(least_reduction * c.norm(), tolerance))) break;
    constraints.observe(-c, m_now.constraints - c);
  }
  if (m_now.solution.converged && m_now.constraints.norm() <= tolerance) return true;
  restore(before);
  return false;
}

bool Potential_search::move_to(const Curvature_potential& rho, const Dirac_options& options,
                               const Go_further& go_further)
{
  refresh(options, go_further);
  Step step;
  step.change = rho.values - m_now.rho.values;
  if (!predict(step)) return false;
  std::optional<Dirac_line> line;
  if (m_system.is_closed()) line = line_along(step);
  const auto guess = predicted(step, 1, line);
  if (!guess) return false;
  const Candidate before = m_now;
  m_now = moved(step, 1, *guess, limited(options), go_further);
  if (m_now.solution.converged) return true;
  restore(before);
  return false;
}

void Potential_search::refresh(const Dirac_options& options, const Go_further& go_further)
{
  if (m_factored_at == m_system.changes())
    measure(m_now);
  else
    m_now = evaluate(m_now.rho.values, m_now.solution, options, go_further);
}

bool Potential_search::take(const Step& step, const Dirac_options& options,
                            const Go_further& go_further)
{
  const Candidate before = m_now;
  std::optional<Dirac_line> line;
  if (m_system.is_closed() && m_constraints.empty()) line = line_along(step);
  for (double t = line ? best_length(step, *line) : (std::min)(1., 2 * m_last_length);
       t >= shortest; t /= 2) {
    if (m_costs.cancelled) break;
    m_now = before;
    const auto guess = predicted(step, t, line);
    if (!guess) continue;
    m_now = moved(step, t, *guess, options, go_further);
    if (!m_now.solution.converged) {
      t /= 2;  // far too long
      continue;
    }
    if (!(merit(m_now) < merit(before)))
      if (const std::optional<Step> second = best_step())
        m_now = moved(*second, options, go_further);
    if (!m_now.solution.converged || !(merit(m_now) < merit(before))) continue;
    m_last_length = t;
    return true;
  }
  restore(before);
  return false;
}

double Potential_search::best_length(const Step& step, const Dirac_line& line) const
{
  double best = shortest, least = merit(m_now);
  for (double t = 1; t >= shortest; t /= 2) {
    const auto guess = line.at(t);
    if (!guess) continue;
    Candidate c;
    c.rho = {m_rho.on, m_now.rho.values + t * step.change};
    c.solution = *guess;
    measure(c);
    if (!(merit(c) < least)) {
      if (least < merit(m_now)) break;  // shorter than the best
      continue;
    }
    best = t;
    least = merit(c);
  }
  return best;
}

auto Potential_search::moved(const Step& step, double t, const Prediction& predicted,
                             const Dirac_options& options, const Go_further& go_further)
    -> Candidate
{
  const Dirac_solution& guess = predicted.solution;
  Candidate next = evaluate(m_now.rho.values + t * step.change, guess, options, go_further);
  if (m_system.overlap(next.solution.lambda, guess.lambda) < predicted.least_overlap)
    next.solution.converged = false;
  return next;
}

auto Potential_search::evaluate(Eigen::VectorXd rho, const Dirac_solution& guess,
                                const Dirac_options& options, const Go_further& go_further)
    -> Candidate
{
  Candidate c;
  c.rho = {m_rho.on, std::move(rho)};
  c.solution = correct_dirac_solution(m_system, c.rho, guess, options, go_further);
  m_costs.cancelled = m_costs.cancelled || c.solution.cancelled;
  add_costs(m_costs, c.solution);
  add_costs(m_costs.seconds, c.solution.seconds);
  measure(c);
  m_factored_at = c.solution.converged ? m_system.changes() : -1;
  return c;
}

void Potential_search::measure(Candidate& c) const
{
  c.residuals = values_at(c.solution.lambda, m_residuals);
  c.constraints = values_at(c.solution.lambda, m_constraints);
  c.sum = m_metric.squared_norm(c.rho.values - m_rho.values) + c.residuals.squaredNorm();
}

}  // namespace Conformal_geometry_processing::internal
