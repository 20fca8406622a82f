// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_BRANCH_TEMPLATES_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_BRANCH_TEMPLATES_H

#include <Conformal_geometry_processing/linear_algebra/direct/Stopwatch.h>
#include <Conformal_geometry_processing/operators/dirac_forms.h>
#include <Conformal_geometry_processing/spin/Dirac_branch.h>
#include <Conformal_geometry_processing/spin/Dirac_search_templates.h>
#include <Conformal_geometry_processing/spin/Dirac_system_templates.h>
#include <Conformal_geometry_processing/spin/generalized_dirac.h>
#include <Conformal_geometry_processing/spin/rayleigh_ritz_of_dirac.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace Conformal_geometry_processing {
namespace internal {

template <class SolverTraits, class EigensolverTraits>
void Dirac_branch<SolverTraits, EigensolverTraits>::solve(const Curvature_potential& rho,
                                                          const Dirac_options& options,
                                                          Dirac_solution& s,
                                                          const Go_further& go_further)
{
  const Quaternion_vector<double> one =
      Quaternion_vector<double>::Constant(m_system.areas().size(), {1, 0, 0, 0});
  s.lambda = one;
  const Found found = find({rho, 0, options.tolerance}, options, s, go_further, true);
  if (!accept(found, options.tolerance, s) && !s.cancelled)
    continue_from_identity(rho, options, found, s, go_further);
  if (options.problem == Dirac_options::Eigenproblem::generalized && s.converged)
    solve_generalized_dirac(m_system, rho, options, s, go_further);
  s.eigenvalue = dirac_quotient(m_system.surface(), rho, s.lambda);
  s.overlap = m_system.overlap(s.lambda, one);
  s.lambda = m_system.normalized(std::move(s.lambda));
}

template <class SolverTraits, class EigensolverTraits>
Curvature_potential Dirac_branch<SolverTraits, EigensolverTraits>::scaled(
    const Curvature_potential& rho, double t, double sigma)
{
  return {rho.on, (t * rho.values.array() + sigma).matrix()};
}

template <class SolverTraits, class EigensolverTraits>
bool Dirac_branch<SolverTraits, EigensolverTraits>::follow(const Step& step,
                                                           const Dirac_options& options,
                                                           Dirac_solution& s,
                                                           const Go_further& go_further)
{
  return accept(find(step, options, s, go_further), step.tolerance, s);
}

template <class SolverTraits, class EigensolverTraits>
auto Dirac_branch<SolverTraits, EigensolverTraits>::find(const Step& step, Dirac_options options,
                                                         Dirac_solution& s,
                                                         const Go_further& go_further,
                                                         bool is_factored) -> Found
{
  options.tolerance = step.tolerance;
  Quaternion_vector<double> start = s.lambda;
  double sigma = step.sigma, separation = 0;
  for (int separations = 0;; ++separations) {
    const Curvature_potential rho = scaled(step.rho, 1, sigma);
    if (!is_factored || separations > 0) m_system.set_potential(rho, s.seconds);
    Stopwatch watch;
    Search search(m_system, rho, s.lambda, options, go_further);
    search.run(start, separation);
    s.iterations += search.iterations();
    s.cancelled = search.is_cancelled();
    s.seconds.eigenvectors += watch.lap();
    if (!search.is_mixed() || separations == max_separations)
      return {std::move(search.result()), sigma};
    const Dirac_forms forms = dirac_forms(m_system.surface(), rho, search.mixture());
    const auto separated = rayleigh_ritz_of_dirac(search.mixture(), forms);
    const auto values = signed_eigenvalues(forms);
    const Eigen::Index nearest = nearest_column(separated, s.lambda);
    if (step.is_between) return {unconverged(separated), sigma};
    start = separated.col(nearest);
    sigma += values[static_cast<std::size_t>(nearest)];
    separation = values[1] - values[0];
  }
}

template <class SolverTraits, class EigensolverTraits>
Eigensolver_result Dirac_branch<SolverTraits, EigensolverTraits>::unconverged(
    const Block<Quaternion<double>>& vectors)
{
  Eigensolver_result r;
  r.vectors = vectors;
  r.values = Eigen::VectorXd::Zero(vectors.cols());
  r.estimates = Eigen::VectorXd::Constant(vectors.cols(), 1);
  return r;
}

template <class SolverTraits, class EigensolverTraits>
bool Dirac_branch<SolverTraits, EigensolverTraits>::accept(const Found& found, double tolerance,
                                                           Dirac_solution& s) const
{
  const Eigensolver_result& r = found.r;
  const Eigen::Index nearest = nearest_column(r.vectors, s.lambda);
  const Quaternion_vector<double> lambda = r.vectors.col(nearest);
  if (m_system.overlap(lambda, s.lambda) < same_branch) return false;
  s.lambda = lambda;
  s.energy = r.values[nearest];
  s.residual = r.estimates[nearest];
  s.converged = s.residual <= tolerance;
  s.spectral_shift = found.sigma;
  s.gap = r.gap ? root(r.values[0] + *r.gap) - root(r.values[0]) : 0;
  return true;
}

template <class SolverTraits, class EigensolverTraits>
Eigen::Index Dirac_branch<SolverTraits, EigensolverTraits>::nearest_column(
    const Block<Quaternion<double>>& vectors, const Quaternion_vector<double>& guide) const
{
  Eigen::VectorXd overlaps(vectors.cols());
  for (Eigen::Index c = 0; c < vectors.cols(); ++c)
    overlaps[c] = m_system.overlap(vectors.col(c), guide);
  Eigen::Index nearest;
  overlaps.maxCoeff(&nearest);
  return nearest;
}

template <class SolverTraits, class EigensolverTraits>
void Dirac_branch<SolverTraits, EigensolverTraits>::continue_from_identity(
    const Curvature_potential& rho, const Dirac_options& options, const Found& smallest,
    Dirac_solution& s, const Go_further& go_further)
{
  const double rough = 1e-3, growth = 1.5, same_problem = 0.1 * std::sqrt(m_system.unit());
  double t = 0, gamma = 0;
  // If the shift is small, the full step has been tried already.
  double dt = std::abs(slope_of(rho, s.lambda)) < same_problem ? 0.5 : 1;
  for (s.substeps = 1; s.substeps < options.max_substeps && !s.cancelled; ++s.substeps) {
    // By first-order perturbation theory, d gamma / dt = -<lambda, rho lambda> / |lambda|^2.
    const double next = (std::min)(t + dt, 1.), slope = slope_of(rho, s.lambda);
    const Step step{scaled(rho, next, 0), gamma + slope * (next - t), rough, next < 1};
    if (follow(step, options, s, go_further)) {
      if (next == 1 || is_continued_by(smallest, s))
        return finish(rho, options, smallest, s, go_further);
      gamma = dirac_quotient(m_system.surface(), step.rho, s.lambda);
      dt *= growth;
      t = next;
    } else {
      dt /= 2;
    }
  }
  s.converged = false;
}

template <class SolverTraits, class EigensolverTraits>
double Dirac_branch<SolverTraits, EigensolverTraits>::slope_of(
    const Curvature_potential& rho, const Quaternion_vector<double>& lambda) const
{
  const Curvature_potential none{rho.on, Eigen::VectorXd::Zero(rho.values.size())};
  return dirac_quotient(m_system.surface(), rho, lambda) -
         dirac_quotient(m_system.surface(), none, lambda);
}

template <class SolverTraits, class EigensolverTraits>
void Dirac_branch<SolverTraits, EigensolverTraits>::finish(const Curvature_potential& rho,
                                                           const Dirac_options& options,
                                                           const Found& smallest, Dirac_solution& s,
                                                           const Go_further& go_further)
{
  const double sigma = s.spectral_shift;
  const bool is_among_them = is_continued_by(smallest, s);
  if (is_among_them) accept(smallest, options.tolerance, s);
  if (is_among_them && s.residual <= options.tolerance) {
    if (options.problem == Dirac_options::Eigenproblem::generalized)
      m_system.set_potential(rho, s.seconds);
    return;
  }
  s.converged = false;
  const bool are_two_known = smallest.sigma == 0 && smallest.r.vectors.cols() == 2;
  if ((is_among_them || !are_two_known) &&
      (follow({rho, 0, options.tolerance}, options, s, go_further) || s.cancelled))
    return;
  const Step shifted{rho, sigma, options.tolerance};
  accept(find(shifted, options, s, go_further, are_two_known && !is_among_them), options.tolerance,
         s);
}

template <class SolverTraits, class EigensolverTraits>
bool Dirac_branch<SolverTraits, EigensolverTraits>::is_continued_by(const Found& smallest,
                                                                    const Dirac_solution& s) const
{
  const auto& vectors = smallest.r.vectors;
  return smallest.sigma == 0 &&
         m_system.overlap(vectors.col(nearest_column(vectors, s.lambda)), s.lambda) >= same_branch;
}

}  // namespace internal
}  // namespace Conformal_geometry_processing

#ifndef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
namespace Conformal_geometry_processing {

extern template class internal::Dirac_branch<Default_solver_traits, Lobpcg_eigensolver_traits>;

}  // namespace Conformal_geometry_processing
#endif

#endif
