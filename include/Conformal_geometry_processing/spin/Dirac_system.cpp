// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Dirac_system.h>

#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Conformal_geometry_processing/spin/Spin_residual.h>
#include <Conformal_geometry_processing/spin/gauge.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>
#include <Quaternionic_linear_algebra/direct/Stopwatch.h>
#include <Quaternionic_linear_algebra/exceptions.h>
#include <Quaternionic_linear_algebra/krylov/conjugate_gradients.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Conformal_geometry_processing {
namespace internal {

void remove_mean(Block<Quaternion<double>>& v, const Eigen::VectorXd& masses)
{
  for (auto column : v.colwise()) {
    Quaternion<double> sum{};
    for (Eigen::Index i = 0; i < v.rows(); ++i) sum += masses[i] * column[i];
    sum *= 1 / masses.sum();
    for (Quaternion<double>& value : column) value -= sum;
  }
}

Block<Quaternion<double>> closed_response(const Hermitian_sparse_matrix<Quaternion<double>>& X,
                                          const Eigen::VectorXd& areas,
                                          const internal::Solver_ref<Quaternion<double>>& solver,
                                          Block<Quaternion<double>> c, double tolerance,
                                          int& solves)
{
  using Vectors = Block<Quaternion<double>>;
  const double worst_error = 1e-6;  // relative, in the energy norm
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(c.rows());
  remove_mean(c, ones);
  const auto factor = inverse_operator(solver);
  // The factor amplifies constants, and with them rounding errors, which X does not see.
  const auto precondition = [&](const Vectors& r, Vectors& z) {
    factor(r, z);
    solves += static_cast<int>(r.cols());
    remove_mean(z, ones);
  };
  Conjugate_gradients_options options;
  options.tolerance = tolerance;
  Vectors y;
  const auto result = conjugate_gradients(block_operator(X), precondition, c, y, options);
  // Slivers leave fewer correct digits, after which the iterations break down.
  if (!result.converged && !(result.estimates.maxCoeff() <= worst_error))
    throw Solver_error("Dirac_system", "the iterations do not converge");
  remove_mean(y, areas);
  return y;
}

}  // namespace internal

internal::Dirac_system::Dirac_system(const Surface_ref& surface,
                                     const Boundary_condition& condition,
                                     const std::string& function, const Spin_solvers& solvers,
                                     const Surface_part& part)
    : m_function(function),
      m_surface(surface),
      m_part(part),
      m_is_closed(boundary_loops(surface).empty()),
      m_is_self_adjoint(condition.is_self_adjoint()),
      m_X(vertex_graph(surface)),
      m_solvers(solvers),
      m_solver(solvers.solver<Quaternion<double>>())
{
  using Kind = Boundary_condition::Kind;
  find_areas();
  require_condition(surface, condition, function);
  check("analysis", m_solver.analyze_with_positions(m_X.pattern(), surface.positions()));
  if (condition.kind == Kind::positions)
    m_positions =
        std::make_unique<Positions>(surface, condition, m_X.shared_pattern(), m_solver, function);
  if (condition.kind != Kind::directions) return;
  m_directions = std::make_unique<Directions>(surface, condition, m_X.shared_pattern(), m_solver);
  m_reduced.emplace();
  check("analysis", m_reduced->analyze_with_positions(m_X.pattern(), m_directions->basis().rows(),
                                                      surface.positions()));
}

void internal::Dirac_system::update_geometry()
{
  ++m_changes;
  m_rho.reset();
  find_areas();
  if (m_directions) m_directions->update_geometry();
}

void internal::Dirac_system::find_areas()
{
  m_areas = vertex_areas(m_surface);
  m_part.clear_others(m_areas);
  m_area = m_part.sum(m_areas.sum());
}

internal::Coefficients internal::Dirac_system::coefficients() const
{
  return m_directions ? internal::Coefficients::reals : internal::Coefficients::quaternions;
}

double internal::Dirac_system::unit() const
{
  const double pi = std::acos(-1.);
  return 4 * pi / m_area;
}

void internal::Dirac_system::assemble(const Curvature_potential& rho,
                                      internal::Dirac_evidence::Seconds& seconds)
{
  internal::Stopwatch watch;
  ++m_changes;
  const bool is_assembled = m_rho && m_rho->on == rho.on && m_rho->values == rho.values;
  if (!is_assembled) assemble_dirac_energy(m_surface, rho, m_X);
  m_rho = rho;
  seconds.assembly += watch.lap();
}

void internal::Dirac_system::set_potential(const Curvature_potential& rho,
                                           internal::Dirac_evidence::Seconds& seconds, Use use,
                                           double least)
{
  assemble(rho, seconds);
  internal::Stopwatch watch;
  m_shift = least * unit();
  Solver_status status = factorize(m_shift * m_areas, use);
  for (const double share : {1e-6, 1e-3, 1e-2}) {
    if (share <= (least < 0 ? 1e-6 : least) || status != Solver_status::not_positive_definite)
      continue;
    m_shift = share * unit();
    status = factorize(m_shift * m_areas, use);
  }
  check("factorization", status);
  seconds.factorization += watch.lap();
}

void internal::Dirac_system::set_potential(const Curvature_potential& rho,
                                           const Eigen::VectorXd& shift,
                                           internal::Dirac_evidence::Seconds& seconds)
{
  assemble(rho, seconds);
  internal::Stopwatch watch;
  check("factorization", factorize(shift, Use::solution));
  seconds.factorization += watch.lap();
}

auto internal::Dirac_system::solve(const Vectors& b) const -> Vectors
{
  Vectors x;
  check("solution", m_reduced ? m_reduced->solve(b, x) : m_solver.solve(b, x));
  return x;
}

auto internal::Dirac_system::precondition(const Vectors& b) const -> Vectors
{
  if (m_directions) return solve(b);
  Vectors x;
  check("solution", apply_inverse(m_solver, b, x));
  return x;
}

void internal::Dirac_system::prepare_response()
{
  internal::Dirac_evidence::Seconds seconds;
  const Curvature_potential none = no_potential(m_surface);
  if (m_is_closed)
    set_potential(none, seconds, Use::preconditioner);
  else if (m_directions)
    set_potential(none, seconds, Use::solution, 1e-6);
  else
    set_potential(none, nearness_weight(m_surface) * m_areas, seconds);
}

auto internal::Dirac_system::response(const Vectors& c, double tolerance, int& solves) const
    -> Vectors
{
  if (!m_is_closed) {
    solves += static_cast<int>(c.cols());
    return solve(c);
  }
  const Eigen::Index at_once = 2;  // columns: the iterations hold eight such blocks
  Vectors y(c.rows(), c.cols());
  for (Eigen::Index first = 0; first < c.cols(); first += at_once) {
    const Eigen::Index count = (std::min)(at_once, c.cols() - first);
    y.middleCols(first, count) = internal::closed_response(
        m_X, m_areas, m_solver, c.middleCols(first, count), tolerance, solves);
  }
  return y;
}

auto internal::Dirac_system::noise(Eigen::Index columns, unsigned seed) const -> Vectors
{
  return precondition(block_operator(m_areas)(random_quaternions(m_areas.size(), columns, seed)));
}

auto internal::Dirac_system::projected(Vectors v) const -> Vectors
{
  return m_directions ? m_directions->basis().project(std::move(v)) : v;
}

void internal::Dirac_system::release()
{
  ++m_changes;
  release_factor(m_solver);
  if (m_reduced) m_reduced->release();
}

double internal::Dirac_system::squared_norm(const Quaternion_vector<double>& a) const
{
  return m_part.sum(inner_product(a, m_areas, a).w);
}

double internal::Dirac_system::overlap(const Quaternion_vector<double>& a,
                                       const Quaternion_vector<double>& b) const
{
  return norm(reduced_to(coefficients(), sum(inner_product(a, m_areas, b)))) /
         std::sqrt(squared_norm(a) * squared_norm(b));
}

double internal::Dirac_system::overlap_with_identity(const Quaternion_vector<double>& a) const
{
  const auto one = Quaternion_vector<double>::Constant(a.size(), {1, 0, 0, 0}).eval();
  return norm(sum(inner_product(a, m_areas, one))) / std::sqrt(squared_norm(a) * m_area);
}

Quaternion_vector<double> internal::Dirac_system::normalized(Quaternion_vector<double> lambda) const
{
  if (m_directions)
    components(lambda) *= std::sqrt(m_area / squared_norm(lambda));
  else
    fix_gauge(lambda, m_areas, m_part);
  return lambda;
}

void internal::Dirac_system::check(const char* step, Solver_status status) const
{
  if (status != Solver_status::success)
    throw Solver_error(m_function, std::string(step) + " of X failed: " + to_string(status));
}

Solver_status internal::Dirac_system::factorize(const Eigen::VectorXd& shift, Use use)
{
  if (m_reduced) return m_reduced->factorize(m_X, shift, m_directions->basis());
  return use == Use::solution ? m_solver.factorize(m_X, shift)
                              : factorize_preconditioner(m_solver, m_X, shift);
}

}  // namespace Conformal_geometry_processing
