// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_EQUATION_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_EQUATION_H

#include <Conformal_geometry_processing/operators/dirac_forms.h>
#include <Conformal_geometry_processing/spin/Dirac_eigenproblem.h>
#include <Conformal_geometry_processing/spin/gauge.h>
#include <Conformal_geometry_processing/spin/generalized_dirac.h>
#include <Conformal_geometry_processing/spin/separate_signs.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief solves (D - rho) lambda = gamma lambda on the branch of eigenvalues that leads to
/// lambda = 1 as rho goes to zero [CGP (5.3)].
///
/// The thesis takes the eigenvalue of smallest modulus. Where rho is strong or has a large mean,
/// that can belong to another branch; a vector is accepted only if it overlaps with the one it
/// continues by more than `same_branch`. If the first solve finds none, rho is switched on in
/// substeps, each looking for the eigenvalue nearest to the one predicted: that of D - rho nearest
/// to sigma is the smallest of D - (rho + sigma). One numeric factorization per substep.
///
/// \tparam SolverTraits a model of `SparseHermitianSolverTraits`
/// \tparam EigensolverTraits a model of `SparseHermitianEigensolverTraits`
template <class SolverTraits = Default_solver_traits,
          class EigensolverTraits = Lobpcg_eigensolver_traits>
class Dirac_equation {
  using Eigenproblem_ = Dirac_eigenproblem<SolverTraits, EigensolverTraits>;

 public:
  /// squares of overlaps with orthogonal vectors add up to at most one: where one is 0.75, every
  /// other is below 0.67
  static constexpr double same_branch = 0.75;

  /// \param mesh must outlive the object
  /// \pre `require_surface(mesh)` and `require_closed(mesh)` hold
  /// \throw Solver_error if the analysis fails
  explicit Dirac_equation(const Mesh_view& mesh) : m_problem(mesh) {}

  const Eigenproblem_& problem() const { return m_problem; }

  /// the mesh has new positions
  void update_geometry() { m_problem.update_geometry(); }

  /// gives back the memory of the factor, until the next `solve()`
  void release() { m_problem.release(); }

  /// \param rho finite values, in 1/length
  /// \param go_further asked between iterations with an `Eigen_progress`; false cancels
  /// \throw Precondition_error if the generalized problem is asked for with rho on vertices
  /// \throw Solver_error if a factorization fails. No convergence is not an error but a field of
  /// the result.
  template <class GoFurther = Always_go_further>
  Dirac_solution solve(const Curvature_potential& rho, const Dirac_options& options = {},
                       GoFurther go_further = {})
  {
    if (options.problem == Eigenproblem::generalized) require_on_faces(rho);
    Dirac_solution s;
    const Quaternion_vector<double> one =
        Quaternion_vector<double>::Constant(m_problem.areas().size(), {1, 0, 0, 0});
    s.lambda = one;
    Step step{rho, 0, options.tolerance};
    if (!follow(step, options, s, go_further) && !s.cancelled)
      if (continue_from_identity(rho, options, s, go_further)) finish(rho, options, s, go_further);
    if (options.problem == Eigenproblem::generalized && s.converged)
      solve_generalized_dirac(m_problem, rho, options, s, go_further);
    s.eigenvalue = dirac_quotient(m_problem.mesh(), rho, s.lambda);
    s.overlap = m_problem.overlap(s.lambda, one);
    fix_gauge(s.lambda, m_problem.areas());
    return s;
  }

 private:
  struct Step {
    Curvature_potential rho;
    double sigma, tolerance;
    int separations = 0;
  };
  struct Effort {
    int wanted = 1, iterations = std::numeric_limits<int>::max();
  };
  static constexpr int max_separations = 4;
  static constexpr int most_if_clear = 12;  ///< iterations: one column alone takes 2 to 8

  static Curvature_potential scaled(const Curvature_potential& rho, double t, double sigma)
  {
    return {rho.on, (t * rho.values.array() + sigma).matrix()};
  }

  /// Replaces s.lambda by the eigenvector nearest to it. Returns false, with s.lambda as it was,
  /// when no vector found is on the same branch.
  template <class GoFurther>
  bool follow(const Step& step, const Dirac_options& options, Dirac_solution& s,
              GoFurther go_further)
  {
    const Curvature_potential rho = scaled(step.rho, 1, step.sigma);
    m_problem.set_potential(rho, s.seconds);
    Stopwatch watch;
    Eigen_result r = smallest(s.lambda, {1, most_if_clear}, step, options, s, go_further);
    const bool one_is_enough = r.cancelled || is_clear(r, rho, s);
    if (!one_is_enough) r = smallest_two(step, options, s, go_further);
    s.seconds.eigenvectors += watch.lap();
    if (one_is_enough || r.cancelled) return accept(r, step, s);
    const Dirac_forms forms = dirac_forms(m_problem.mesh(), rho, r.vectors);
    if (has_mixed_signs(forms) && step.separations < max_separations)
      return separate(step, separate_signs(r.vectors, forms), options, s, go_further);
    return accept(r, step, s);
  }

  /// Whether one vector tells all: it is on the branch of s.lambda, and X has not mixed it with one
  /// of opposite sign.
  bool is_clear(const Eigen_result& r, const Curvature_potential& rho,
                const Dirac_solution& s) const
  {
    if (!r.converged) return false;
    const Quaternion_vector<double> v = r.vectors.col(0);
    if (m_problem.overlap(v, s.lambda) < same_branch) return false;
    const double gamma = dirac_quotient(m_problem.mesh(), rho, v);
    if (is_surely_unmixed(gamma, r.values[0])) return true;
    const auto both = m_problem.with_companion(v, rho);
    const bool is_alone = m_problem.squared_norm(both.col(1)) == 0;
    return is_alone || !has_mixed_signs(dirac_forms(m_problem.mesh(), rho, both));
  }

  template <class GoFurther>
  Eigen_result smallest_two(const Step& step, const Dirac_options& options, Dirac_solution& s,
                            GoFurther go_further)
  {
    Eigen_result r =
        smallest(m_problem.start(s.lambda, options.random_seed), {}, step, options, s, go_further);
    if (nearest_column(r.vectors, s.lambda) > 0 && !r.cancelled)
      r = smallest(r.vectors, {2}, step, options, s, go_further);
    return r;
  }

  /// Where X has mixed lambda with a vector of opposite sign: a shift by the signed eigenvalue of
  /// lambda moves the other one away. It may bring a third vector in, so this is repeated; what
  /// remains then is the error of a coarse mesh.
  template <class GoFurther>
  bool separate(Step step, const Block<Quaternion<double>>& vectors, const Dirac_options& options,
                Dirac_solution& s, GoFurther go_further)
  {
    const Quaternion_vector<double> lambda = vectors.col(nearest_column(vectors, s.lambda));
    step.sigma = dirac_quotient(m_problem.mesh(), step.rho, lambda);
    ++step.separations;
    return follow(step, options, s, go_further);
  }

  bool accept(const Eigen_result& r, const Step& step, Dirac_solution& s) const
  {
    const Eigen::Index nearest = nearest_column(r.vectors, s.lambda);
    const Quaternion_vector<double> lambda = r.vectors.col(nearest);
    if (m_problem.overlap(lambda, s.lambda) < same_branch) return false;
    s.lambda = lambda;
    s.energy = r.values[nearest];
    s.residual = r.estimates[nearest];
    s.converged = s.residual <= step.tolerance;
    s.spectral_shift = step.sigma;
    s.gap = r.gap ? root(r.values[0] + *r.gap) - root(r.values[0]) : 0;
    return true;
  }

  template <class GoFurther>
  Eigen_result smallest(Block<Quaternion<double>> start, Effort effort, const Step& step,
                        const Dirac_options& options, Dirac_solution& s, GoFurther go_further)
  {
    Eigen_result r =
        m_problem.smallest(std::move(start), effort.wanted, step.tolerance,
                           std::min(effort.iterations, options.max_iterations), go_further);
    s.iterations += r.iterations;
    s.cancelled = r.cancelled;
    return r;
  }

  static double root(double mu) { return std::sqrt(std::max(mu, 0.)); }

  Eigen::Index nearest_column(const Block<Quaternion<double>>& vectors,
                              const Quaternion_vector<double>& guide) const
  {
    Eigen::VectorXd overlaps(vectors.cols());
    for (Eigen::Index c = 0; c < vectors.cols(); ++c)
      overlaps[c] = m_problem.overlap(vectors.col(c), guide);
    Eigen::Index nearest;
    overlaps.maxCoeff(&nearest);
    return nearest;
  }

  /// Leads s.lambda from 1 at t = 0 to a rough eigenvector of t rho at t = 1, in steps as large as
  /// keep to the branch. Returns false when the substeps are used up.
  template <class GoFurther>
  bool continue_from_identity(const Curvature_potential& rho, const Dirac_options& options,
                              Dirac_solution& s, GoFurther go_further)
  {
    const double rough = 1e-3, growth = 1.5;
    double t = 0, dt = 1, gamma = 0;
    for (s.substeps = 1; s.substeps < options.max_substeps && !s.cancelled; ++s.substeps) {
      // By first-order perturbation theory, d gamma / dt = -<lambda, rho lambda> / |lambda|^2.
      const double next = std::min(t + dt, 1.), slope = slope_of(rho, s.lambda);
      const Step step{scaled(rho, next, 0), gamma + slope * (next - t), rough};
      if (follow(step, options, s, go_further)) {
        if (next == 1) return true;
        gamma = dirac_quotient(m_problem.mesh(), step.rho, s.lambda);
        dt *= growth;
        t = next;
      } else {
        dt /= 2;
      }
    }
    s.converged = false;
    return false;
  }

  /// d gamma / dt for D - t rho at the eigenvector lambda
  double slope_of(const Curvature_potential& rho, const Quaternion_vector<double>& lambda) const
  {
    const Curvature_potential none{rho.on, Eigen::VectorXd::Zero(rho.values.size())};
    return dirac_quotient(m_problem.mesh(), rho, lambda) -
           dirac_quotient(m_problem.mesh(), none, lambda);
  }

  /// Makes the rough eigenvector exact: that of [CGP (5.3)] if the branch is among its smallest
  /// ones, else that of the shifted problem.
  template <class GoFurther>
  void finish(const Curvature_potential& rho, const Dirac_options& options, Dirac_solution& s,
              GoFurther go_further)
  {
    const double sigma = s.spectral_shift;
    s.converged = false;
    if (!follow({rho, 0, options.tolerance}, options, s, go_further) && !s.cancelled)
      follow({rho, sigma, options.tolerance}, options, s, go_further);
  }

  Eigenproblem_ m_problem;
};

}  // namespace Conformal_geometry_processing

#endif
