// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Relaxed_spins.h>

#include <Conformal_geometry_processing/linear_algebra/dense/block_products.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/conjugate_gradients.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <Eigen/Core>

#include <cmath>
#include <utility>

namespace Conformal_geometry_processing::internal {

/// |y| / |lambda| of each vertex, root mean square over the area
double relative_size(const Quaternion_vector<double>& y, const Quaternion_vector<double>& lambda,
                     const Eigen::VectorXd& areas)
{
  double sum = 0;
  for (Eigen::Index v = 0; v < y.size(); ++v)
    sum += areas[v] * squared_norm(y[v]) / squared_norm(lambda[v]);
  return std::sqrt(sum / areas.sum());
}

double default_misfit_weight(const Surface_ref& surface)
{
  double sum = 0;
  for (int k = 0; k < surface.size_of_edges(); ++k)
    sum += (surface.position(surface.ends(k)[1]) - surface.position(surface.ends(k)[0])).norm();
  const double h = sum / surface.size_of_edges();
  const double pi = std::acos(-1.);
  return .1 * face_areas(surface).sum() / (4 * pi * h * h);
}

Relaxed_spins::Relaxed_spins(Dirac_system& system, const Curvature_potential& rho,
                             Spin_residuals residuals, const Options& options)
    : m_system(system),
      m_residuals(std::move(residuals)),
      m_options(options),
      m_alpha(options.alpha > 0 ? options.alpha : default_misfit_weight(system.surface())),
      m_metric(system, rho.on, .1 / system.unit(), Potential_metric::Factor::later),
      m_constants_are_free(system.is_closed()),
      m_wanted(rho.values),
      m_lambda(Spins::Constant(system.areas().size(), {1, 0, 0, 0})),
      m_rho{rho.on, Eigen::VectorXd::Zero(rho.values.size())}
{}

void Relaxed_spins::restart(const Spins& lambda, const Eigen::VectorXd& rho)
{
  m_moved = m_options.reuse;  // an old factor may belong to far away spins
  m_lambda = normalized(lambda);
  m_rho.values = rho;
}

auto Relaxed_spins::normalized(Spins lambda) const -> Spins
{
  components(lambda) *= std::sqrt(m_system.areas().sum() / m_system.squared_norm(lambda));
  return lambda;
}

// <d, K d> of d without its mean where constants are free.
Eigen::VectorXd Relaxed_spins::metric_product(const Eigen::VectorXd& d) const
{
  const Eigen::VectorXd& areas = m_metric.areas();
  Eigen::VectorXd image = m_metric.apply(d);
  if (m_constants_are_free) image -= areas * (areas.dot(d) / areas.sum());
  return image;
}

auto Relaxed_spins::terms_at(const Spins& lambda, const Eigen::VectorXd& rho) const -> Terms
{
  const Dirac_linearization here(m_system.surface(), {m_rho.on, rho}, lambda);
  const Eigen::VectorXd e = rho - m_wanted;
  return {m_alpha * here.squared_norm(here.residual()), e.dot(metric_product(e)),
          values_at(lambda, m_residuals).squaredNorm()};
}

auto Relaxed_spins::gradient() -> Step
{
  const Dirac_linearization here(m_system.surface(), m_rho, m_lambda);
  const Spins r = here.residual();
  Step g;
  g.spins = m_alpha * here.adjoint(r);
  g.potential = metric_product(m_rho.values - m_wanted) - m_alpha * here.turned(r);
  for (Spin_residual* residual : m_residuals) {
    residual->set_spins(m_lambda);
    g.spins += residual->gradient(residual->values());
  }
  return g;
}

void Relaxed_spins::linearize()
{
  m_linear.emplace(m_system.surface(), m_rho, m_lambda);
  for (Spin_residual* residual : m_residuals) residual->set_spins(m_lambda);
  m_metric.couple(m_lambda, m_alpha);
  ++m_costs.scalar_factorizations;
  if (m_constants_are_free) m_constants = m_metric.solve(m_metric.areas());
  ++m_costs.scalar_solves;
  factorize();
}

Eigen::VectorXd Relaxed_spins::stiffness() const
{
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(m_lambda.size());
  for (const Spin_residual* residual : m_residuals)
    if (const Eigen::VectorXd s = residual->stiffness(); s.size() > 0) sum += s;
  return sum;
}

// The shift is that of the smallest eigenvalue, which is gauge, and leaves enough digits.
void Relaxed_spins::factorize()
{
  const double least = 1e-3, most_change = 4;
  const Eigen::VectorXd shift = stiffness() / m_alpha + least * m_system.unit() * m_system.areas();
  const double ratio = shift.sum() / m_factored_stiffness;
  const bool is_kept = m_system.changes() == m_factored_changes && m_moved < m_options.reuse &&
                       ratio < most_change && ratio > 1 / most_change;
  if (is_kept) return;
  m_system.set_potential(m_rho, shift, m_costs.seconds);
  ++m_costs.factorizations;
  m_moved = 0;
  m_factored_stiffness = shift.sum();
  m_factored_changes = m_system.changes();
}

// H less the product of the areas: by the formula of Sherman and Morrison.
Eigen::VectorXd Relaxed_spins::solve_potential(const Eigen::VectorXd& b)
{
  Eigen::VectorXd d = m_metric.solve(b);
  ++m_costs.scalar_solves;
  if (!m_constants_are_free) return d;
  const Eigen::VectorXd& areas = m_metric.areas();
  return d + m_constants * (areas.dot(d) / (areas.sum() - areas.dot(m_constants)));
}

auto Relaxed_spins::residual_product(const Spins& y) const -> Spins
{
  Spins sum = Spins::Constant(y.size(), {});
  for (const Spin_residual* residual : m_residuals) sum += residual->gradient(residual->change(y));
  return sum;
}

auto Relaxed_spins::schur_product(const Spins& y) -> Spins
{
  Spins z = m_linear->apply(y);
  z -= m_linear->turn(solve_potential(m_alpha * m_linear->turned(z)));
  return m_alpha * m_linear->adjoint(z) + residual_product(y);
}

auto Relaxed_spins::without_gauge(Spins y) const -> Spins
{
  const Quaternion<double> q =
      inner_product(m_lambda, m_system.areas(), y) * (-1 / m_system.squared_norm(m_lambda));
  add_multiple(y, m_lambda, q);
  return y;
}

auto Relaxed_spins::without_gauge_gradient(Spins g) const -> Spins
{
  const Quaternion<double> q = inner_product(m_lambda, g) * (-1 / m_system.squared_norm(m_lambda));
  const Eigen::VectorXd& areas = m_system.areas();
  for (Eigen::Index v = 0; v < g.size(); ++v) g[v] += areas[v] * (m_lambda[v] * q);
  return g;
}

auto Relaxed_spins::solve_schur(const Spins& b, int& iterations) -> Spins
{
  using Vectors = Block<Quaternion<double>>;
  const auto product = [&](const Vectors& y) -> Vectors {
    return without_gauge_gradient(schur_product(y.col(0)));
  };
  const auto precondition = [&](const Vectors& g) -> Vectors {
    ++m_costs.solves;
    return without_gauge(m_system.precondition(g).col(0) / m_alpha);
  };
  Conjugate_gradients_options options;
  options.tolerance = m_options.tolerance;
  options.max_iterations = m_options.max_iterations;
  Vectors x;
  const Vectors right = without_gauge_gradient(b);
  iterations = conjugate_gradients(product, precondition, right, x, options).iterations;
  return x.col(0);
}

auto Relaxed_spins::step() -> Step
{
  const Step g = gradient();
  const Spins coupling = m_linear->adjoint(m_linear->turn(solve_potential(g.potential)));
  Step s;
  s.spins = solve_schur(-1. * (g.spins + m_alpha * coupling), m_iterations);
  s.potential = solve_potential(m_alpha * m_linear->turned(m_linear->apply(s.spins)) - g.potential);
  s.slope = inner_product(g.spins, s.spins).w + g.potential.dot(s.potential);
  return s;
}

bool Relaxed_spins::is_far_from_zero(const Spins& lambda) const
{
  const double least = .1;  // of what each spin was
  for (Eigen::Index v = 0; v < lambda.size(); ++v)
    if (!(squared_norm(lambda[v]) > least * least * squared_norm(m_lambda[v]))) return false;
  return true;
}

auto Relaxed_spins::advance() -> Progress
{
  const double shortest = 1. / 256, decrease = 1e-4;
  linearize();
  const Step s = step();
  Progress p;
  p.iterations = m_iterations;
  p.before = p.after = terms().sum();
  for (double t = 1; t >= shortest; t /= 2) {
    const Spins there = m_lambda + t * s.spins;
    if (!is_far_from_zero(there)) continue;
    const Spins lambda = normalized(there);
    const Eigen::VectorXd rho = m_rho.values + t * s.potential;
    const double sum = terms_at(lambda, rho).sum();
    if (!(sum <= p.before + 2 * decrease * t * s.slope)) continue;
    p.after = sum;
    p.length = t;
    p.moved = t * relative_size(s.spins, m_lambda, m_system.areas());
    m_lambda = lambda;
    m_rho.values = rho;
    break;
  }
  m_moved += p.moved;
  return p;
}

}  // namespace Conformal_geometry_processing::internal
