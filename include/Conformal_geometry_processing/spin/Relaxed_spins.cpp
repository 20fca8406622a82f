// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Relaxed_spins.h>

#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Quaternionic_linear_algebra/dense/block_operators.h>
#include <Quaternionic_linear_algebra/exceptions.h>
#include <Quaternionic_linear_algebra/krylov/conjugate_gradients.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing::internal {

Potential_metric::Potential_metric(const Dirac_system& system, double s)
    : m_part(system.part()),
      m_areas(system.areas()),
      m_matrix(system.matrix().shared_pattern()),
      m_coupled(system.solver().another<double>())
{
  const Surface_ref& surface = system.surface();
  assemble_cotan_laplacian(surface, s * cotan_weights(surface), m_matrix);
  for (int v = 0; v < m_matrix.size(); ++v)
    m_matrix.value(diagonal_position(m_matrix.pattern(), v)) += m_areas[v];
  check(m_coupled.analyze_like(m_matrix.pattern(), system.solver()));
}

void Potential_metric::couple(double w)
{
  check(m_coupled.factorize(m_matrix, w * m_areas));
}

Eigen::MatrixXd Potential_metric::solve_coupled(const Eigen::MatrixXd& b) const
{
  Block<double> x;
  check(m_coupled.solve(b, x));
  return x;
}

Eigen::MatrixXd Potential_metric::apply(const Eigen::MatrixXd& d) const
{
  Eigen::MatrixXd y(d.rows(), d.cols());
  for (Eigen::Index k = 0; k < d.cols(); ++k) m_matrix.multiply(d.col(k), y.col(k));
  m_part.clear_others(y);
  return y;
}

void Potential_metric::check(Solver_status status)
{
  if (status != Solver_status::success) throw Solver_error("Potential_metric", to_string(status));
}

/// |y| / |lambda| of each vertex, root mean square over the area
double relative_size(const Quaternion_vector<double>& y, const Quaternion_vector<double>& lambda,
                     const Dirac_system& system)
{
  Eigen::VectorXd squares(y.size());
  for (Eigen::Index v = 0; v < y.size(); ++v)
    squares[v] = squared_norm(y[v]) / squared_norm(lambda[v]);
  return std::sqrt(system.mean(squares));
}

double default_vertex_weight(const Surface_ref& surface, const Surface_part& part)
{
  const double pi = std::acos(-1.);
  Eigen::Vector2d sums(0, 0);  // of areas, and of edges over the area
  for (int s = 0; s < part.own_faces(surface.size_of_sheets()); ++s) {
    const Sheet sheet = surface.sheet(s);
    const double area = sheet.share * sheet.area;
    sums += Eigen::Vector2d(area, area * std::sqrt(4 / std::sqrt(3.) * sheet.area));
  }
  sums = part.sum(sums);
  return 1.5 * std::sqrt(sums[0] / (4 * pi)) / (sums[1] / sums[0]);
}

Misfit_weights completed(Misfit_weights weights, const Dirac_system& system)
{
  if (weights.vertices == 0)
    weights.vertices = default_vertex_weight(system.surface(), system.part());
  return {weights.factor * weights.sheets, weights.factor * weights.vertices};
}

/// those of a minimisation, with the nearness to 1 where there is one
Spin_residuals with_nearness(Spin_residuals residuals, std::optional<Nearness_residual>& nearness)
{
  if (nearness) residuals.push_back(&*nearness);
  return residuals;
}

Relaxed_spins::Relaxed_spins(Dirac_system& system, Eigen::VectorXd rho, Spin_residuals residuals,
                             const Options& options)
    : m_system(system),
      m_gauge(system),
      m_options(options),
      m_geometry(system.surface(), system.part()),
      m_weights(completed(options.weights, system)),
      m_nearness(m_gauge.is_free()
                     ? std::optional<Nearness_residual>(
                           m_weights.sum() * nearness_weight(system.surface(), system.part()) *
                           system.areas())
                     : std::nullopt),
      m_residuals(with_nearness(std::move(residuals), m_nearness)),
      m_metric(system, options.smoothness / system.unit()),
      m_preconditioner(system, m_residuals, m_weights.sum(), options.reuse),
      m_constants_are_free(system.is_self_adjoint()),
      m_wanted(std::move(rho)),
      m_lambda(start()),
      m_rho(Eigen::VectorXd::Zero(m_wanted.size()))
{
  couple();
}

auto Relaxed_spins::start() const -> Spins
{
  if (const auto* directions = m_system.directions())
    return m_gauge.normalized(directions->guide());
  return Spins::Constant(m_system.areas().size(), {1, 0, 0, 0});
}

void Relaxed_spins::restart(const Spins& lambda, const Eigen::VectorXd& rho)
{
  m_preconditioner.forget();
  m_here.reset();
  m_lambda = m_gauge.normalized(lambda);
  m_rho = rho;
}

void Relaxed_spins::stiffen(double factor)
{
  m_weights.sheets *= factor;
  m_weights.vertices *= factor;
  m_here.reset();
  m_preconditioner.set_weight(m_weights.sum());
  if (m_nearness) m_nearness->scale(factor);
  couple();
}

void Relaxed_spins::couple()
{
  m_metric.couple(m_weights.sum());
  ++m_costs.scalar_factorizations;
  if (m_constants_are_free) m_constants = m_metric.solve_coupled(m_metric.areas());
  ++m_costs.scalar_solves;
}

Dirac_misfit Relaxed_spins::misfit(const Spins& lambda, const Eigen::VectorXd& rho) const
{
  return {m_geometry, m_weights, rho, lambda};
}

const Dirac_misfit& Relaxed_spins::here() const
{
  if (!m_here) m_here.emplace(misfit(m_lambda, m_rho));
  return *m_here;
}

// K d of d without its mean where constants are free.
Eigen::VectorXd Relaxed_spins::metric_product(const Eigen::VectorXd& d) const
{
  const Eigen::VectorXd& areas = m_metric.areas();
  Eigen::VectorXd image = m_metric.apply(d);
  if (m_constants_are_free) image -= areas * m_system.mean(d);
  return image;
}

auto Relaxed_spins::terms_of(const Dirac_misfit& there) const -> Terms
{
  const Eigen::VectorXd e = there.rho() - m_wanted;
  const Surface_part& part = m_system.part();
  return {there.squared_norm(there.residual().misfit), part.sum(e.dot(metric_product(e))),
          part.sum(values_at(there.lambda(), m_residuals).squaredNorm())};
}

auto Relaxed_spins::gradient() -> Step
{
  const Dirac_misfit::Image& r = here().residual();
  Step g;
  g.spins = here().adjoint(r.misfit, Eigen::VectorXd::Zero(m_rho.size()));
  g.potential = metric_product(m_rho - m_wanted) - r.turned;
  for (Spin_residual* residual : m_residuals) {
    residual->set_spins(m_lambda);
    g.spins += residual->gradient(residual->values());
  }
  return g;
}

void Relaxed_spins::linearize()
{
  for (Spin_residual* residual : m_residuals) residual->set_spins(m_lambda);
  m_preconditioner.update(m_lambda, m_rho, m_costs);
}

// H less the product of the areas: by the formula of Sherman and Morrison.
Eigen::MatrixXd Relaxed_spins::solve_potential(const Eigen::MatrixXd& b)
{
  Eigen::MatrixXd d = m_metric.solve_coupled(b);
  m_costs.scalar_solves += static_cast<int>(b.cols());
  if (!m_constants_are_free) return d;
  const Eigen::VectorXd& areas = m_metric.areas();
  const Eigen::VectorXd sums = m_system.part().sum(d.transpose() * areas);
  const double rest = 1 - m_system.mean(m_constants);
  return d + m_constants * (sums.transpose() / (m_system.area() * rest));
}

auto Relaxed_spins::schur_product(const Vectors& y) -> Vectors
{
  std::vector<Spins> misfits;
  Eigen::MatrixXd turned(y.rows(), y.cols());
  for (Eigen::Index k = 0; k < y.cols(); ++k) {
    Dirac_misfit::Image z = here().apply(y.col(k));
    turned.col(k) = z.turned;
    misfits.push_back(std::move(z.misfit));
  }
  const Eigen::MatrixXd d = solve_potential(turned);
  Vectors product(y.rows(), y.cols());
  for (Eigen::Index k = 0; k < y.cols(); ++k)
    product.col(k) = here().adjoint(misfits[static_cast<std::size_t>(k)], d.col(k)) +
                     m_preconditioner.residual_product(y.col(k));
  return product;
}

auto Relaxed_spins::solve_schur(Vectors b, const std::function<bool()>& go_further) -> Vectors
{
  const auto product = [&](const Vectors& y) -> Vectors {
    Vectors z = schur_product(y);
    for (Eigen::Index k = 0; k < y.cols(); ++k)
      z.col(k) = m_gauge.projected_gradient(m_lambda, z.col(k));
    return z;
  };
  const auto precondition = [&](const Vectors& g) -> Vectors {
    return m_preconditioner.apply(g, m_costs);
  };
  Conjugate_gradients_options options;
  // What the preconditioner leaves to the iterations is stiff: they find the rest after it.
  const double share = m_preconditioner.leaves_few() ? .1 : 1;
  options.tolerance = share * m_options.tolerance;
  if (m_options.negligible > 0 && !m_preconditioner.has_few())
    options.negligible = m_options.negligible * terms().sum();
  options.max_iterations = m_options.max_iterations;
  options.leading_columns = 1;
  options.go_further = go_further;
  options.sum_of_parts = m_system.part().sum_of_parts;
  for (Eigen::Index k = 0; k < b.cols(); ++k)
    b.col(k) = m_gauge.projected_gradient(m_lambda, b.col(k));
  Vectors x;
  m_iterations = conjugate_gradients(product, precondition, b, x, options).iterations;
  return x;
}

auto Relaxed_spins::step(const Unknown& unknown, const std::function<bool()>& go_further) -> Step
{
  const Step g = gradient();
  const Spins nothing = Spins::Constant(here().residual().misfit.size(), {});
  const bool asks = unknown.choose && unknown.response.size() == 0;
  Vectors forces(m_lambda.size(), asks ? 2 : 1);
  forces.col(0) = here().adjoint(nothing, solve_potential(g.potential)) - g.spins;
  if (asks) forces.col(1) = unknown.force;
  const Vectors changes = solve_schur(std::move(forces), go_further);
  Step s;
  s.spins = changes.col(0);
  double t = 0;
  if (unknown.choose) {
    const Spins response = asks ? Spins(changes.col(1)) : unknown.response;
    t = unknown.choose(m_lambda + s.spins, response);
    s.spins += t * response;
  }
  s.potential = solve_potential(here().apply(s.spins).turned - g.potential);
  s.slope = product(g, s);
  if (t != 0) s.slope -= std::expm1(t) * m_system.sum(inner_product(unknown.force, s.spins)).w;
  return s;
}

double Relaxed_spins::product(const Step& g, const Step& s) const
{
  return m_system.part().sum(inner_product(g.spins, s.spins).w + g.potential.dot(s.potential));
}

bool Relaxed_spins::is_far_from_zero(const Spins& lambda) const
{
  const double least = .1;  // of what each spin was
  double shorter = 0;       // how many
  for (Eigen::Index v = 0; v < lambda.size(); ++v)
    if (!(squared_norm(lambda[v]) > least * least * squared_norm(m_lambda[v]))) ++shorter;
  return m_system.part().sum(shorter) == 0;
}

auto Relaxed_spins::advance(const std::function<bool()>& go_further, const Unknown& unknown)
    -> Progress
{
  const double shortest = 1. / 256, decrease = 1e-4;
  Progress p;
  linearize();
  const Step s = step(unknown, [&] { return !(p.cancelled = go_further && !go_further()); });
  if (p.cancelled) return p;
  p.iterations = m_iterations;
  p.before = p.after = terms().sum();
  for (double t = 1; t >= shortest; t /= 2) {
    const Spins there = m_lambda + t * s.spins;
    if (!is_far_from_zero(there)) continue;
    Dirac_misfit next = misfit(m_gauge.normalized(there), m_rho + t * s.potential);
    const double sum = terms_of(next).sum();
    if (!(sum <= p.before + 2 * decrease * t * s.slope)) continue;
    p.after = sum;
    p.length = t;
    p.moved = t * relative_size(s.spins, m_lambda, m_system);
    m_lambda = next.lambda();
    m_rho = next.rho();
    m_here.emplace(std::move(next));
    break;
  }
  m_preconditioner.moved(p.moved);
  return p;
}

void Relaxed_spins::meet_few(bool is_anew)
{
  if (is_anew) linearize();
  const Spins y =
      m_preconditioner.correction(values_at(m_lambda, vanishing_of(m_residuals)), m_costs);
  if (!is_far_from_zero(m_lambda - y)) return;
  m_preconditioner.moved(relative_size(y, m_lambda, m_system));
  m_lambda = m_gauge.normalized(m_lambda - y);
  m_here.reset();
}

}  // namespace Conformal_geometry_processing::internal
