// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// The eigenpair at the end of a stage.
#include <Conformal_geometry_processing/spin/Dirac_branch.h>

#include <Conformal_geometry_processing/linear_algebra/direct/Stopwatch.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/Eigensolver_result.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/Lobpcg.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>

#include <algorithm>
#include <cmath>

namespace Conformal_geometry_processing::internal {

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
  const Eigensolver_result r =
      m_options.eigensolver(m_system.matrix(), m_system.areas(), m_system.solver(),
                            Vectors(m_s.lambda), options, go_further);
  m_s.lambda = r.vectors.col(0);
  m_s.energy = r.values[0];
  m_s.residual = r.estimates[0];
  m_s.iterations += r.iterations;
  m_s.solves += r.solves;
  m_s.cancelled = r.cancelled;
  m_s.seconds.eigenvectors += watch.lap() - (m_s.seconds.assembly - assembly);
}

}  // namespace Conformal_geometry_processing::internal
