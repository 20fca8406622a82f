// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// The steps of a `Potential_search`, from derivatives.
#include <Conformal_geometry_processing/spin/Potential_search.h>

#include <Conformal_geometry_processing/linear_algebra/direct/Stopwatch.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/conjugate_gradients.h>
#include <Conformal_geometry_processing/spin/Dirac_line.h>
#include <Conformal_geometry_processing/spin/Potential_metric.h>
#include <Conformal_geometry_processing/spin/Spin_derivative.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace Conformal_geometry_processing::internal {

auto Potential_search::best_step() -> std::optional<Step>
{
  Stopwatch watch;
  std::optional<Step> step;
  try {
    step = best_step(derivative());
  } catch (const No_derivative&) {
    // none, then
  }
  m_costs.seconds.eigenvectors += watch.lap();
  return step;
}

auto Potential_search::derivative() const -> Derivative
{
  const double tolerance = 1e-3;
  const double gamma = m_system.is_closed() ? m_now.solution.eigenvalue : 0;
  return Derivative(m_system, {m_rho.on, m_now.rho.values.array() + gamma}, m_now.solution.lambda,
                    tolerance);
}

auto Potential_search::best_step(const Derivative& S) -> Step
{
  const Eigen::MatrixXd gradients =
      S.apply_transpose(gradients_of(m_constraints, S.lambda().size()));
  const Linear_constraints& constraints =
      m_last_constraints.emplace(gradients, m_metric.solve(gradients), dampings_of(m_constraints));
  const Eigen::VectorXd g = gradient(S);
  Step step;
  step.change = constraints.least_solution(-m_now.constraints);
  const Eigen::VectorXd rest = improvement(S, constraints, g, step.change);
  step.is_improvement = rest.size() > 0;
  if (step.is_improvement) step.change += rest;
  step.lambda = S.apply(step.change).col(0);
  step.gamma = S.gamma_change(step.change)[0];
  double rise = 2 * g.dot(step.change) + m_metric.squared_norm(step.change);
  for (const Spin_residual* r : m_residuals) rise += r->change(step.lambda).squaredNorm();
  // The sum may rise to satisfy constraints, but not by more than the price of what is satisfied.
  const Eigen::VectorXd left = m_now.constraints + gradients.transpose() * step.change;
  const double reduction = m_now.constraints.norm() - left.norm();
  if (reduction > 0) m_penalty = (std::max)(m_penalty, 2 * rise / reduction);
  m_costs.solves += S.number_of_solves();
  return step;
}

Eigen::VectorXd Potential_search::improvement(const Derivative& S,
                                              const Linear_constraints& constraints,
                                              const Eigen::VectorXd& g,
                                              const Eigen::VectorXd& first) const
{
  const double tolerance = 5e-2;
  const auto hessian = [&](const Block<double>& d, Block<double>& y) { y = curvature(S, d); };
  const auto precondition = [&](const Block<double>& r, Block<double>& z) {
    z = constraints.project_out(m_metric.solve(r));
  };
  Eigen::VectorXd slope = -g;
  if (first.squaredNorm() > 0) slope -= curvature(S, first);
  // Near the minimum nearly all of it is in the span of the constraints, and would be rounding.
  const Block<double> b = constraints.project_gradient(slope);
  Block<double> d;
  Conjugate_gradients_options options;
  // K bounds K + S^T S from below, and thereby what is left to gain from above: it ends at a fifth
  // of the least.
  precondition(b, d);
  const double left = b.col(0).dot(d.col(0)) / m_now.sum;
  options.tolerance = (std::max)(tolerance, std::sqrt(least_gain / 5 / left));
  conjugate_gradients(hessian, precondition, b, d, options);
  if (b.col(0).dot(d.col(0)) <= least_gain * m_now.sum) return {};
  return d.col(0);
}

Eigen::VectorXd Potential_search::gradient(const Derivative& S) const
{
  const Eigen::VectorXd g = m_metric.apply(m_now.rho.values - m_rho.values);
  const double rounding = 1e-12;  // whose gradient is noise, on which iterations do not converge
  if (m_now.residuals.norm() <= rounding * std::sqrt(m_now.sum)) return g;
  Block<Quaternion<double>> q = Block<Quaternion<double>>::Constant(S.lambda().size(), 1, {});
  for (const Spin_residual* r : m_residuals) q.col(0) += r->gradient(r->values());
  return g + S.apply_transpose(q);
}

Eigen::VectorXd Potential_search::curvature(const Derivative& S, const Eigen::VectorXd& d) const
{
  if (m_residuals.empty()) return m_metric.apply(d);
  using Inverse = typename Derivative::Inverse;
  // Constraints are kept by exact gradients, which an approximate minimum would work against.
  const Inverse inverse = m_constraints.empty() ? Inverse::factor : Inverse::iterated;
  const Spins dlambda = S.apply(d, inverse).col(0);
  Block<Quaternion<double>> q = Block<Quaternion<double>>::Constant(dlambda.size(), 1, {});
  for (const Spin_residual* r : m_residuals) q.col(0) += r->gradient(r->change(dlambda));
  return m_metric.apply(d) + S.apply_transpose(q, inverse);
}

bool Potential_search::predict(Step& step)
{
  try {
    const Derivative S = derivative();
    step.lambda = S.apply(step.change).col(0);
    step.gamma = S.gamma_change(step.change)[0];
    m_costs.solves += S.number_of_solves();
    return true;
  } catch (const No_derivative&) {
    return false;
  }
}

Dirac_line Potential_search::line_along(const Step& step)
{
  Stopwatch watch;
  Dirac_line line(m_system, m_now.rho, m_now.solution, step.change, step.lambda);
  m_costs.solves += line.number_of_solves();
  m_costs.seconds.eigenvectors += watch.lap();
  return line;
}

auto Potential_search::predicted(const Step& step, double t) const -> Prediction
{
  const double least_overlap = 0.98;
  Dirac_solution guess = m_now.solution;
  components(guess.lambda) += t * components(step.lambda);
  guess.eigenvalue += t * step.gamma;
  return {std::move(guess), least_overlap};
}

auto Potential_search::predicted(const Step& step, double t,
                                 const std::optional<Dirac_line>& line) const
    -> std::optional<Prediction>
{
  const double least_overlap = 0.9;  // the line knows of the other branches near by
  if (!line) return predicted(step, t);
  std::optional<Dirac_solution> guess = line->at(t);
  if (!guess) return std::nullopt;
  return Prediction{std::move(*guess), least_overlap};
}

}  // namespace Conformal_geometry_processing::internal
