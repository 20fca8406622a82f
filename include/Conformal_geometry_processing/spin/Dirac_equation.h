// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_EQUATION_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_EQUATION_H

#include <Conformal_geometry_processing/operators/dirac_forms.h>
#include <Conformal_geometry_processing/spin/Dirac_eigenproblem.h>
#include <Conformal_geometry_processing/spin/Dirac_search.h>
#include <Conformal_geometry_processing/spin/gauge.h>
#include <Conformal_geometry_processing/spin/generalized_dirac.h>
#include <Conformal_geometry_processing/spin/separate_signs.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
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
/// to sigma is the smallest of D - (rho + sigma). One numeric factorization per substep, and one
/// for each time that X mixes vectors of opposite sign. The vectors of the first solve are kept:
/// a substep that comes near enough to one of them is the last.
///
/// \tparam SolverTraits a model of `SparseHermitianSolverTraits`
/// \tparam EigensolverTraits a model of `SparseHermitianEigensolverTraits`
/// \tparam Surface `Mesh_view`, or `Delaunay_view` for the robust operators
template <class SolverTraits = Default_solver_traits,
          class EigensolverTraits = Lobpcg_eigensolver_traits, class Surface = Mesh_view>
class Dirac_equation {
  using Eigenproblem_ = Dirac_eigenproblem<SolverTraits, EigensolverTraits, Surface>;

 public:
  /// the overlap that a vector must exceed with the one it continues
  static constexpr double same_branch =
      internal::Dirac_search<Eigenproblem_>::same_branch;

  /// \param mesh must outlive the object
  /// \pre `require_surface(mesh)` holds, and before `solve()` `require_closed(mesh)`
  /// \throw Solver_error if the analysis fails
  explicit Dirac_equation(const Surface& mesh) : m_problem(mesh) {}

  const Eigenproblem_& problem() const { return m_problem; }
  Eigenproblem_& problem() { return m_problem; }

  /// the mesh has new positions
  void update_geometry() { m_problem.update_geometry(); }

  /// gives back the memory of the factor, until the next `solve()`
  void release() { m_problem.release(); }

  /// \param rho finite values, in 1/length
  /// \param go_further asked between iterations with an `Eigen_progress`; false cancels
  /// \throw Precondition_error if the generalized problem is asked for with rho on vertices
  /// \throw Solver_error if a factorization fails. No convergence is not an error but a field of
  /// the result.
  Dirac_solution solve(const Curvature_potential& rho, const Dirac_options& options = {},
                       const Go_further& go_further = Always_go_further())
  {
    if (options.problem == Eigenproblem::generalized) require_on_faces(rho);
    Dirac_solution s;
    const Quaternion_vector<double> one =
        Quaternion_vector<double>::Constant(m_problem.areas().size(), {1, 0, 0, 0});
    s.lambda = one;
    const Found found = find({rho, 0, options.tolerance}, options, s, go_further);
    if (!accept(found, options.tolerance, s) && !s.cancelled)
      continue_from_identity(rho, options, found, s, go_further);
    if (options.problem == Eigenproblem::generalized && s.converged)
      solve_generalized_dirac(m_problem, rho, options, s, go_further);
    s.eigenvalue = dirac_quotient(m_problem.mesh(), rho, s.lambda);
    s.overlap = m_problem.overlap(s.lambda, one);
    fix_gauge(s.lambda, m_problem.areas());
    return s;
  }

 private:
  /// one potential of the continuation
  struct Step {
    Curvature_potential rho;
    double sigma, tolerance;
    bool is_between = false;  ///< before the last: a vector that guides the next one is enough
  };
  /// eigenvectors of X for the potential rho + sigma
  struct Found {
    Eigen_result r;
    double sigma;
  };
  static constexpr int max_separations = 4;

  static Curvature_potential scaled(const Curvature_potential& rho, double t, double sigma)
  {
    return {rho.on, (t * rho.values.array() + sigma).matrix()};
  }

  /// Replaces s.lambda by the eigenvector nearest to it. Returns false, with s.lambda as it was,
  /// when no vector found is on the same branch.
  bool follow(const Step& step, const Dirac_options& options, Dirac_solution& s,
              const Go_further& go_further)
  {
    return accept(find(step, options, s, go_further), step.tolerance, s);
  }

  /// \brief the eigenvectors in question as the continuation of s.lambda.
  ///
  /// Where X has mixed lambda with a vector of opposite sign: a shift by the signed eigenvalue of
  /// lambda moves the other one away. It may bring a third vector in, so this is repeated; what
  /// remains then is the error of a coarse mesh.
  Found find(const Step& step, Dirac_options options, Dirac_solution& s, const Go_further& go_further,
             bool is_factored = false)
  {
    options.tolerance = step.tolerance;
    Quaternion_vector<double> start = s.lambda;
    double sigma = step.sigma, separation = 0;
    for (int separations = 0;; ++separations) {
      const Curvature_potential rho = scaled(step.rho, 1, sigma);
      if (!is_factored || separations > 0) m_problem.set_potential(rho, s.seconds);
      Stopwatch watch;
      internal::Dirac_search search(m_problem, rho, s.lambda, options, go_further);
      search.run(start, separation);
      s.iterations += search.iterations();
      s.cancelled = search.is_cancelled();
      s.seconds.eigenvectors += watch.lap();
      if (!search.is_mixed() || separations == max_separations)
        return {std::move(search.result()), sigma};
      const Dirac_forms forms = dirac_forms(m_problem.mesh(), rho, search.mixture());
      const auto separated = separate_signs(search.mixture(), forms);
      const auto values = signed_eigenvalues(forms);
      const Eigen::Index nearest = nearest_column(separated, s.lambda);
      if (step.is_between) return {unconverged(separated), sigma};
      start = separated.col(nearest);
      sigma += values[static_cast<std::size_t>(nearest)];
      separation = values[1] - values[0];
    }
  }

  /// vectors of which no more is known
  static Eigen_result unconverged(const Block<Quaternion<double>>& vectors)
  {
    Eigen_result r;
    r.vectors = vectors;
    r.values = Eigen::VectorXd::Zero(vectors.cols());
    r.estimates = Eigen::VectorXd::Constant(vectors.cols(), 1);
    return r;
  }

  bool accept(const Found& found, double tolerance, Dirac_solution& s) const
  {
    const Eigen_result& r = found.r;
    const Eigen::Index nearest = nearest_column(r.vectors, s.lambda);
    const Quaternion_vector<double> lambda = r.vectors.col(nearest);
    if (m_problem.overlap(lambda, s.lambda) < same_branch) return false;
    s.lambda = lambda;
    s.energy = r.values[nearest];
    s.residual = r.estimates[nearest];
    s.converged = s.residual <= tolerance;
    s.spectral_shift = found.sigma;
    s.gap = r.gap ? root(r.values[0] + *r.gap) - root(r.values[0]) : 0;
    return true;
  }

  static double root(double mu) { return std::sqrt((std::max)(mu, 0.)); }

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

  /// Leads s.lambda from 1 at t = 0 to an eigenvector of t rho at t = 1, in steps as large as keep
  /// to the branch. Gives up when the substeps are used up.
  /// \param smallest found without shift, none of them near 1
  void continue_from_identity(const Curvature_potential& rho, const Dirac_options& options,
                              const Found& smallest, Dirac_solution& s, const Go_further& go_further)
  {
    const double rough = 1e-3, growth = 1.5, same_problem = 0.1 * std::sqrt(m_problem.unit());
    double t = 0, gamma = 0;
    // Where the shift is small, the whole step has been tried already.
    double dt = std::abs(slope_of(rho, s.lambda)) < same_problem ? 0.5 : 1;
    for (s.substeps = 1; s.substeps < options.max_substeps && !s.cancelled; ++s.substeps) {
      // By first-order perturbation theory, d gamma / dt = -<lambda, rho lambda> / |lambda|^2.
      const double next = (std::min)(t + dt, 1.), slope = slope_of(rho, s.lambda);
      const Step step{scaled(rho, next, 0), gamma + slope * (next - t), rough, next < 1};
      if (follow(step, options, s, go_further)) {
        if (next == 1 || is_continued_by(smallest, s))
          return finish(rho, options, smallest, s, go_further);
        gamma = dirac_quotient(m_problem.mesh(), step.rho, s.lambda);
        dt *= growth;
        t = next;
      } else {
        dt /= 2;
      }
    }
    s.converged = false;
  }

  /// d gamma / dt for D - t rho at the eigenvector lambda
  double slope_of(const Curvature_potential& rho, const Quaternion_vector<double>& lambda) const
  {
    const Curvature_potential none{rho.on, Eigen::VectorXd::Zero(rho.values.size())};
    return dirac_quotient(m_problem.mesh(), rho, lambda) -
           dirac_quotient(m_problem.mesh(), none, lambda);
  }

  /// Makes the rough eigenvector exact: that of [CGP (5.3)] if the branch is among its smallest
  /// ones, else that of the shifted problem, which is the one factored.
  void finish(const Curvature_potential& rho, const Dirac_options& options, const Found& smallest,
              Dirac_solution& s, const Go_further& go_further)
  {
    const double sigma = s.spectral_shift;
    const bool is_among_them = is_continued_by(smallest, s);
    if (is_among_them) accept(smallest, options.tolerance, s);
    if (is_among_them && s.residual <= options.tolerance) {
      if (options.problem == Eigenproblem::generalized) m_problem.set_potential(rho, s.seconds);
      return;
    }
    s.converged = false;
    const bool are_two_known = smallest.sigma == 0 && smallest.r.vectors.cols() == 2;
    if ((is_among_them || !are_two_known) &&
        (follow({rho, 0, options.tolerance}, options, s, go_further) || s.cancelled))
      return;
    const Step shifted{rho, sigma, options.tolerance};
    accept(find(shifted, options, s, go_further, are_two_known && !is_among_them),
           options.tolerance, s);
  }

  /// one of the vectors found without shift is on the branch of s.lambda
  bool is_continued_by(const Found& smallest, const Dirac_solution& s) const
  {
    const auto& vectors = smallest.r.vectors;
    return smallest.sigma == 0 && m_problem.overlap(vectors.col(nearest_column(vectors, s.lambda)),
                                                    s.lambda) >= same_branch;
  }

  Eigenproblem_ m_problem;
};

}  // namespace Conformal_geometry_processing

#endif
