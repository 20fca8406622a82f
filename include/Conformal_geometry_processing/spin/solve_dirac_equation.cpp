// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/solve_dirac_equation.h>

#include <Conformal_geometry_processing/spin/Dirac_branch.h>
#include <Conformal_geometry_processing/spin/Directions_selection.h>
#include <Conformal_geometry_processing/spin/Spin_residual.h>
#include <Quaternionic_linear_algebra/dense/hermitian_eigen_decomposition.h>
#include <Quaternionic_linear_algebra/direct/Stopwatch.h>
#include <Quaternionic_linear_algebra/exceptions.h>

namespace Conformal_geometry_processing {

Vector<Quaternion<double>> constant_spins(const internal::Reduced_basis<double>& basis)
{
  const int n = basis.rows().size();
  Block<Quaternion<double>> units(n, 4);
  for (int i = 0; i < n; ++i)
    units.row(i) << Quaternion<double>{1, 0, 0, 0}, Quaternion<double>{0, 1, 0, 0},
        Quaternion<double>{0, 0, 1, 0}, Quaternion<double>{0, 0, 0, 1};
  const Block<Quaternion<double>> rest = units - basis.project(units);
  const auto eigen = hermitian_eigen_decomposition(real_gram_matrix(rest, rest));
  const double rounding = 1e-20 * n;
  const Eigen::Index count = (eigen.values.array() <= rounding).count();
  Vector<Quaternion<double>> spins(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Eigen::Vector4d q = eigen.vectors.col(k);
    spins[k] = {q[0], q[1], q[2], q[3]};
  }
  return spins;
}

void solve_generalized_dirac(internal::Dirac_system& system, const Curvature_potential& rho,
                             const Dirac_options& options, internal::Dirac_solution& s,
                             const internal::Go_further& go_further)
{
  const double gamma = dirac_quotient(system.surface(), rho, s.lambda);
  system.set_potential(rho, s.seconds, internal::Dirac_system::Use::preconditioner);
  ++s.factorizations;
  const double mu =
      inner_product(s.lambda, system.matrix() * s.lambda).w / system.squared_norm(s.lambda);
  if (gamma == 0 || mu <= 0) return;
  const double guess = gamma / mu;  // 1 / g
  const auto K = dirac_form(system.surface(), rho);
  const auto energy = block_operator(system.matrix());
  const auto form = block_operator(K);
  // The vector of largest |1/g| and of the sign of gamma is the smallest of the pencil (-+K, X).
  const auto apply_k = [&](const Block<Quaternion<double>>& x) {
    return Block<Quaternion<double>>(form(x) * (gamma > 0 ? -1. : 1.));
  };
  // Eigenvectors have X > 0; the constants only barely, if rho is tiny.
  const double positive = 1e-12 * system.unit();
  const auto apply_x = [&](const Block<Quaternion<double>>& x) {
    Block<Quaternion<double>> y = energy(x);
    for (Eigen::Index c = 0; c < x.cols(); ++c)
      for (Eigen::Index i = 0; i < x.rows(); ++i)
        y(i, c) += (positive * system.areas()[i]) * x(i, c);
    return y;
  };
  Eigensolver_options eigen;
  eigen.tolerance = options.tolerance;
  eigen.max_iterations = options.max_iterations;
  eigen.scale = std::abs(guess);
  Block<Quaternion<double>> start(s.lambda.size(), 2);
  start << s.lambda, system.noise(1, options.random_seed);
  const Eigensolver_result r =
      lobpcg(apply_k, apply_x, inverse_operator(system.solver()), start, eigen, go_further);
  s.iterations += r.iterations;
  s.solves += 1 + 2 * r.solves;  // the noise, and two columns
  s.cancelled = r.cancelled;
  const Quaternion_vector<double> lambda = r.vectors.col(0);
  const double same_branch = 0.99;
  if (!r.converged || system.overlap(lambda, s.lambda) < same_branch) return;
  s.eigenvalue = dirac_quotient(system.surface(), rho, lambda);
  s.overlap = system.overlap_with_identity(lambda);
  s.lambda = system.normalized(lambda);
  s.residual = r.estimates[0];
  s.is_generalized = true;
  s.generalized_eigenvalue = (gamma > 0 ? -1 : 1) / r.values[0];
}

namespace internal {

Block<Quaternion<double>> constants_in_space(const Dirac_system& system)
{
  Vector<Quaternion<double>> spins =
      Vector<Quaternion<double>>::Constant(1, Quaternion<double>{1, 0, 0, 0});
  if (system.directions()) spins = constant_spins(system.directions()->basis());
  Block<Quaternion<double>> v(system.areas().size(), spins.size());
  for (Eigen::Index c = 0; c < v.cols(); ++c)
    v.col(c).setConstant(spins[c] / std::sqrt(system.areas().sum()));
  return v;
}

Block<Quaternion<double>> beside_constants(const Dirac_system& system,
                                           const Block<Quaternion<double>>& constants,
                                           Block<Quaternion<double>> b)
{
  using Vectors = Block<Quaternion<double>>;
  add_combination(b, Vectors(block_operator(system.areas())(constants)),
                  Vectors(-gram_matrix(constants, b, system.coefficients())));
  return b;
}

Block<Quaternion<double>> solve_beside(const Dirac_system& system,
                                       const Block<Quaternion<double>>& constants,
                                       Block<Quaternion<double>> b)
{
  using Vectors = Block<Quaternion<double>>;
  Vectors x = system.solve(beside_constants(system, constants, std::move(b)));
  const Vectors masses = block_operator(system.areas())(constants);
  add_combination(x, constants, Vectors(-gram_matrix(masses, x, system.coefficients())));
  return x;
}

Pencil pencil_of_masses(const Dirac_system& system, const Block<Quaternion<double>>& constants)
{
  using Vectors = Block<Quaternion<double>>;
  Pencil pencil;
  pencil.coefficients = system.coefficients();
  pencil.K = [&system, &constants](const Vectors& v) {
    return system.projected(beside_constants(system, constants, block_operator(system.areas())(v)));
  };
  pencil.N = [&system](const Vectors& v) {
    Vectors w = block_operator(system.matrix())(v);
    for (Eigen::Index c = 0; c < v.cols(); ++c)
      for (Eigen::Index i = 0; i < v.rows(); ++i)
        w(i, c) += (system.shift() * system.areas()[i]) * v(i, c);
    return system.projected(std::move(w));
  };
  pencil.solve = [&system, &constants](const Vectors& b) {
    return solve_beside(system, constants, b);
  };
  return pencil;
}

Pencil pencil_of_form(const Dirac_system& system, const Curvature_potential& rho,
                      const Block<Quaternion<double>>& constants)
{
  using Vectors = Block<Quaternion<double>>;
  Pencil pencil = pencil_of_masses(system, constants);
  pencil.K = [&system, &rho](const Vectors& v) {
    Vectors w(v.rows(), v.cols());
    for (Eigen::Index c = 0; c < v.cols(); ++c)
      w.col(c) = apply_dirac_form(system.surface(), rho, v.col(c));
    return system.projected(std::move(w));
  };
  return pencil;
}

Dirac_forms forms_in_space(const Dirac_system& system, const Curvature_potential& rho,
                           const Block<Quaternion<double>>& v)
{
  Dirac_forms forms = dirac_forms(system.surface(), rho, v);
  for (Block<Quaternion<double>>* form : {&forms.dirac, &forms.mass})
    for (Eigen::Index k = 0; k < form->size(); ++k)
      form->data()[k] = reduced_to(system.coefficients(), form->data()[k]);
  return forms;
}

void require_generalized(const Dirac_system& system, const Curvature_potential& rho)
{
  if (!system.is_closed())
    throw Precondition_error("solve_dirac_equation",
                             "the generalized problem is for closed surfaces only");
  if (rho.on != Curvature_potential::On::faces)
    throw Precondition_error("solve_dirac_equation",
                             "the generalized eigenproblem (5.2) needs rho on faces");
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
