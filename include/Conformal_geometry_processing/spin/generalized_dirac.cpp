// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/generalized_dirac.h>

#include <Conformal_geometry_processing/exceptions.h>

namespace Conformal_geometry_processing {

void require_on_faces(const Curvature_potential& rho)
{
  if (rho.on != Curvature_potential::On::faces)
    throw Precondition_error("solve_dirac_equation",
                             "the generalized eigenproblem (5.2) needs rho on faces");
}

void solve_generalized_dirac(internal::Dirac_system& system, const Curvature_potential& rho,
                             const Dirac_options& options, internal::Dirac_solution& s,
                             const internal::Go_further& go_further)
{
  const double gamma = dirac_quotient(system.surface(), rho, s.lambda);
  system.set_preconditioner(rho, s.seconds);
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

}  // namespace Conformal_geometry_processing
