// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Dirac_branch.h>

#include <Quaternionic_linear_algebra/direct/Stopwatch.h>
#include <Quaternionic_linear_algebra/krylov/Lobpcg.h>

#include <utility>

namespace Conformal_geometry_processing::internal {

Dirac_branch::Dirac_branch(System& system, const Curvature_potential& rho,
                           const Dirac_options& options, Dirac_solution& s,
                           const Go_further& go_further)
    : m_system(system), m_rho(rho), m_options(options), m_s(s), m_go_further(go_further)
{
  m_s.lambda = Quaternion_vector<double>::Constant(system.areas().size(), {1, 0, 0, 0});
  add(m_s.lambda);
}

void Dirac_branch::solve()
{
  Branch_point at, next;
  double end = 1;
  place_pole(1, dirac_quotient(m_system.surface(), m_rho, m_s.lambda));
  extend(1);
  for (m_s.substeps = 1; m_s.substeps <= m_options.max_substeps; ++m_s.substeps) {
    next = predict(at, end);
    if (!is_near_pole(next)) place_pole(next.t, next.gamma);
    const Branch_point predicted = next;
    m_s.lambda = in_span(next);
    // Where the end of the branch is predicted from afar, it is looked at before it is computed.
    const bool is_sure = m_s.substeps == 1 && !predicted.is_settled;
    refine(next, next.t == 1 && is_sure ? m_options.tolerance : 1e-3);
    if (next.t == 1 && !is_sure && is_as_predicted(at, predicted, next))
      refine(next, m_options.tolerance);
    if (m_s.cancelled || (!m_s.converged && m_s.iterations >= m_options.max_iterations)) break;
    if (!is_as_predicted(at, predicted, next)) {
      m_s.lambda = in_span(at);
      if (predicted.is_settled) {  // a stage that is tried again with less trust does not count
        m_may_settle = false;
        --m_s.substeps;
      } else {
        end = (at.t + next.t) / 2;
      }
      continue;
    }
    at = next;
    if (at.t == 1) return conclude(at);
    end = 1;
    forget_early_vectors();
    add(m_s.lambda);
    extend(3);
  }
  m_s.substeps = (std::min)(m_s.substeps, m_options.max_substeps);
  conclude(next);
  m_s.converged = false;
}

Curvature_potential Dirac_branch::potential(double t, double sigma) const
{
  return {m_rho.on, (t * m_rho.values.array() + sigma).matrix()};
}

void Dirac_branch::place_pole(double t, double sigma)
{
  m_pole.t = t;
  m_pole.gamma = sigma;
  m_system.set_potential(potential(t, sigma), m_s.seconds, System::Use::preconditioner);
  ++m_s.factorizations;
}

bool Dirac_branch::is_near_pole(const Branch_point& p) const
{
  return p.t == m_pole.t && std::abs(p.gamma - m_pole.gamma) <= p.least_gap / 4;
}

bool Dirac_branch::turns_off(const Branch_point& from, const Branch_point& to) const
{
  const double shortest = 1. / 16, greatest_bend = 0.2, step = to.t - from.t;
  if (step <= shortest) return false;
  const double before = m_gram.quotient(0, from.c) - m_gram.quotient(1, from.c),
               after = potential_quotient(m_system.surface(), m_rho, m_s.lambda);
  const double expected = -step * (before + after) / 2;
  return std::abs(to.gamma - from.gamma - expected) > greatest_bend * to.least_gap;
}

bool Dirac_branch::is_as_predicted(const Branch_point& from, const Branch_point& predicted,
                                   const Branch_point& to) const
{
  if (m_system.overlap(m_s.lambda, in_span(predicted)) < same_vector) return false;
  const double greatest_error = 0.2;
  return predicted.is_settled
             ? std::abs(to.gamma - predicted.gamma) <= greatest_error * to.least_gap
             : !turns_off(from, to);
}

bool Dirac_branch::add(Quaternion_vector<double> v)
{
  return extend_orthonormal(m_span, m_system.areas(), std::move(v));
}

void Dirac_branch::extend(int words)
{
  Stopwatch watch;
  for (int k = 0; k < words && m_span.cols() < most_vectors; ++k) {
    const Quaternion_vector<double> last = m_span.rightCols(1).col(0);
    const Vectors b = apply_dirac_form(m_system.surface(), potential(m_pole.t, m_pole.gamma), last);
    Vectors w;
    inverse_operator(m_system.solver())(b, w);
    ++m_s.solves;
    if (!add(w.col(0))) break;
  }
  m_s.seconds.eigenvectors += watch.lap();
}

void Dirac_branch::forget_early_vectors()
{
  const Eigen::Index kept = 5;
  if (m_span.cols() <= kept + 1) return;
  m_span.middleCols(1, kept) = m_span.rightCols(kept).eval();
  m_span.conservativeResize(Eigen::NoChange, kept + 1);
  m_gram.forget_all_but(kept);
}

Branch_point Dirac_branch::predict(Branch_point& first, double end)
{
  const double step = 1. / 48;
  Branch_point p;
  for (const double least_overlap : {0.98, 0.9, 0.85}) {
    if (least_overlap < 0.98) extend(2);
    Stopwatch watch;
    m_gram.extend(m_system.surface(), m_rho, m_span);
    m_s.largest_span = (std::max)(m_s.largest_span, static_cast<int>(m_span.cols()));
    first.c = gram_matrix(m_span, block_operator(m_system.areas())(Vectors(m_s.lambda))).col(0);
    components(first.c) /= components(first.c).norm();
    p = follow_branch(m_gram, first, end, least_overlap);
    if (p.t < end && m_may_settle) {
      const Branch_point settled = follow_settled_branch(m_gram, first, end);
      if (settled.t > p.t) p = settled;
    }
    m_s.seconds.eigenvectors += watch.lap();
    if (p.t == end) return p;
  }
  if (p.t == first.t) p.t = (std::min)(end, first.t + step);
  return p;
}

void Dirac_branch::conclude(const Branch_point& p)
{
  m_s.eigenvalue = p.gamma;
  m_s.dirac_residual = dirac_misfit(m_system.surface(), potential(p.t, p.gamma), m_s.lambda);
  m_s.spectral_shift = m_pole.gamma;
  m_s.gap = std::isfinite(p.gap) ? p.gap : 0;
  m_s.branch_gap = std::isfinite(p.least_gap) ? p.least_gap : 0;
  m_s.overlap = m_system.overlap_with_identity(m_s.lambda);
  m_s.lambda = m_system.normalized(std::move(m_s.lambda));
}

void Dirac_branch::refine(Branch_point& p, double tolerance)
{
  const int max_passes = 12;
  Branch_point at = p;  // gamma is the shift of X
  double last_sigma = 0;
  m_secant.restart();
  m_follows_quotient = true;
  for (int pass = 0; pass < max_passes; ++pass) {
    m_system.assemble(potential(at.t, at.gamma), m_s.seconds);
    iterate(at, tolerance);
    const double sigma = at.gamma, change = quotient_change(at, m_s.lambda);
    p.gamma = sigma + change;
    m_s.converged = m_s.residual <= tolerance && std::abs(change) <= stationary(tolerance);
    if (m_s.converged || m_s.cancelled || m_s.iterations >= m_options.max_iterations) return;
    const bool has_moved = pass > 0 && sigma != last_sigma;
    if (pass > 1 && !has_moved) return;  // rounding errors keep the residual above the tolerance
    last_sigma = sigma;
    move(at, m_secant.step(sigma, change, stationary(tolerance)));
  }
}

void Dirac_branch::iterate(Branch_point& at, double tolerance)
{
  smallest(at, tolerance);
  const bool is_pole = m_pole.t == at.t && m_pole.gamma == at.gamma;
  if (m_s.residual <= tolerance || m_s.cancelled || is_pole) return;
  place_pole(at.t, at.gamma);
  smallest(at, tolerance);
}

bool Dirac_branch::follow_quotient(Branch_point& at, double tolerance,
                                   const Eigensolver_progress& iterate)
{
  const double settled = 1e-2;  // before, the iterate may not be on the branch yet
  if (iterate.estimate > settled || !m_follows_quotient) return false;
  const double change = quotient_change(at, iterate.vectors->col(0)),
               error = stationary(iterate.estimate) / 10;
  if (std::abs(change) <= stationary(tolerance)) return false;
  m_follows_quotient = m_secant.is_nearer(change);
  if (!m_follows_quotient) return false;
  move(at, m_secant.step(at.gamma, change, error));
  m_system.assemble(potential(at.t, at.gamma), m_s.seconds);
  return true;
}

void Dirac_branch::smallest(Branch_point& at, double tolerance)
{
  Stopwatch watch;
  const double assembly = m_s.seconds.assembly;
  Eigensolver_options options;
  options.tolerance = tolerance;
  options.max_iterations = (std::max)(m_options.max_iterations - m_s.iterations, 0);
  options.scale = std::sqrt(m_system.unit());
  options.adapt = [&](const auto& iterate) { return follow_quotient(at, tolerance, iterate); };
  const auto go_further = [this, done = m_s.iterations](Eigensolver_progress p) {
    p.iteration += done;
    return m_go_further(p);
  };
  Vectors start = m_s.lambda;
  m_s.lambda.resize(0);  // leaves its memory to the eigensolver
  const Eigensolver_result r =
      m_options.eigensolver(m_system.matrix(), m_system.areas(), m_system.solver(),
                            std::move(start), options, go_further);
  m_s.lambda = r.vectors.col(0);
  m_s.energy = r.values[0];
  m_s.residual = r.estimates[0];
  m_s.iterations += r.iterations;
  m_s.solves += r.solves;
  m_s.cancelled = r.cancelled;
  m_s.seconds.eigenvectors += watch.lap() - (m_s.seconds.assembly - assembly);
}

}  // namespace Conformal_geometry_processing::internal
