// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/solve_dirac_equation.h>

#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/spin/Dirac_branch.h>
#include <Conformal_geometry_processing/spin/Directions_selection.h>
#include <Conformal_geometry_processing/spin/Spin_residual.h>
#include <Conformal_geometry_processing/spin/dirac_pencils.h>
#include <Quaternionic_linear_algebra/direct/Stopwatch.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {
namespace internal {

void require_generalized(const Dirac_system& system, const Curvature_potential& rho)
{
  if (!system.is_closed())
    throw Precondition_error("solve_dirac_equation",
                             "the generalized problem is for closed surfaces only");
  require_on_faces(rho);
}

void solve_with_positions(Dirac_system& system, const Curvature_potential& rho, Dirac_solution& s)
{
  system.assemble(rho, s.seconds);
  Stopwatch watch;
  auto& positions = *system.positions();
  positions.factorize(system.matrix());
  s.seconds.factorization += watch.lap();
  s.lambda = positions.spins(system.matrix());
  s.solves = 1;
  s.residual = positions.residual(system.matrix(), s.lambda);
  s.seconds.eigenvectors += watch.lap();
}

void solve_with_free_boundary(Dirac_system& system, const Curvature_potential& rho,
                              Dirac_solution& s)
{
  const Eigen::VectorXd weights = nearness_weight(system.surface()) * system.areas();
  system.set_potential(rho, weights, s.seconds);
  Stopwatch watch;
  Block<Quaternion<double>> b(weights.size(), 1);
  for (Eigen::Index i = 0; i < b.rows(); ++i) b(i, 0) = {weights[i], 0, 0, 0};
  s.lambda = system.solve(b).col(0);
  s.solves = 1;
  Quaternion_vector<double> rest = system.matrix() * s.lambda - b.col(0);
  for (Eigen::Index i = 0; i < b.rows(); ++i) rest[i] += weights[i] * s.lambda[i];
  s.residual = components(rest).norm() / weights.norm();
  s.seconds.eigenvectors += watch.lap();
}

}  // namespace internal

internal::Dirac_solution solve_dirac_equation(internal::Dirac_system& system,
                                              const Curvature_potential& rho,
                                              const Dirac_options& options,
                                              const internal::Go_further& go_further)
{
  if (options.problem == Dirac_options::Eigenproblem::generalized)
    internal::require_generalized(system, rho);
  internal::Dirac_solution s;
  if (system.is_closed()) {
    internal::Dirac_branch(system, rho, options, s, go_further).solve();
    if (options.problem == Dirac_options::Eigenproblem::generalized && s.converged)
      solve_generalized_dirac(system, rho, options, s, go_further);
    return s;
  }
  s.factorizations = 1;
  if (system.directions()) {
    system.set_potential(rho, s.seconds);
    internal::Directions_selection(system, rho, options).solve(s, go_further);
    return s;
  }
  if (system.positions())
    internal::solve_with_positions(system, rho, s);
  else
    internal::solve_with_free_boundary(system, rho, s);
  s.energy = inner_product(s.lambda, system.matrix() * s.lambda).w / system.squared_norm(s.lambda);
  s.eigenvalue = dirac_misfit(system.surface(), rho, s.lambda);  // without the cancellation in X
  s.converged = components(s.lambda).allFinite();
  s.overlap = system.overlap_with_identity(s.lambda);
  return s;
}

}  // namespace Conformal_geometry_processing
