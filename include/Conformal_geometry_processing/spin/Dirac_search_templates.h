// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_SEARCH_TEMPLATES_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_SEARCH_TEMPLATES_H

#include <Conformal_geometry_processing/operators/dirac_forms.h>
#include <Conformal_geometry_processing/spin/Dirac_search.h>
#include <Conformal_geometry_processing/spin/Dirac_system_templates.h>
#include <Conformal_geometry_processing/spin/rayleigh_ritz_of_dirac.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace Conformal_geometry_processing {
namespace internal {

template <class SolverTraits, class EigensolverTraits>
Dirac_search<SolverTraits, EigensolverTraits>::Dirac_search(const System& system,
                                                            const Curvature_potential& rho,
                                                            const Quaternion_vector<double>& guide,
                                                            const Dirac_options& options,
                                                            const Go_further& go_further)
    : m_system(system), m_rho(rho), m_guide(guide), m_options(options), m_go_further(go_further)
{}

template <class SolverTraits, class EigensolverTraits>
void Dirac_search<SolverTraits, EigensolverTraits>::run(const Quaternion_vector<double>& start,
                                                        double separation)
{
  one_column(start, separation);
  if (is_cancelled() || is_mixed()) return;
  const Quaternion_vector<double> v = m_result.vectors.col(0);
  if (m_result.converged && !m_is_judged && !stays_separated(v, start, separation))
    judge(v, m_result.values[0]);
  if (is_mixed()) return;
  if (m_is_doubtful)
    two_columns(m_suspects);
  else if (!m_result.converged)
    two_columns(side_by_side(v, m_system.noise(1, m_options.random_seed)));
  else if (another_may_be_nearer(v))
    two_columns(side_by_side(v, without(v, m_guide)));
}

template <class SolverTraits, class EigensolverTraits>
void Dirac_search<SolverTraits, EigensolverTraits>::one_column(const Vectors& start,
                                                               double separation)
{
  bool is_enough = false;
  const auto watch = [&](const Eigensolver_progress& p) {
    if (p.vectors && p.estimate <= rough && !m_is_judged && separation == 0)
      judge(p.vectors->col(0), p.value);
    const bool is_slow = p.iteration >= 12 || (p.iteration >= 3 && p.estimate > 3 * rough);
    is_enough = is_slow || is_mixed() || m_is_doubtful;
    return !is_enough && m_go_further(p);
  };
  iterate(start, 1, m_options.tolerance, watch);
  m_is_cancelled = m_result.cancelled && !is_enough;
}

template <class SolverTraits, class EigensolverTraits>
void Dirac_search<SolverTraits, EigensolverTraits>::two_columns(const Vectors& start)
{
  if (!iterate(start, 2, (std::max)(m_options.tolerance, rough), m_go_further)) return;
  m_is_cancelled = m_result.cancelled;
  if (is_cancelled()) return;
  m_is_mixed = separation_pays(dirac_forms(m_system.surface(), m_rho, m_result.vectors));
  m_suspects = m_result.vectors;
  if (is_mixed()) return;
  const bool first =
      m_system.overlap(m_suspects.col(0), m_guide) >= m_system.overlap(m_suspects.col(1), m_guide);
  if (iterate(m_suspects, first ? 1 : 2, m_options.tolerance, m_go_further))
    m_is_cancelled = m_result.cancelled;
}

template <class SolverTraits, class EigensolverTraits>
void Dirac_search<SolverTraits, EigensolverTraits>::judge(const Quaternion_vector<double>& v,
                                                          double mu)
{
  m_is_judged = true;
  const Quaternion_vector<double> image = apply_dirac_form(m_system.surface(), m_rho, v);
  // A lower bound of the modulus of the quotient, because averaging shortens vectors.
  const double least = inner_product(v, image).w / m_system.squared_norm(v);
  if (is_surely_unmixed(least, mu)) return;
  Vectors companions = companion(v, image);
  double before = std::numeric_limits<double>::infinity();
  while (true) {
    m_suspects = with_lowest(v, companions);
    if (m_suspects.cols() == 1) return;
    const Dirac_forms forms = dirac_forms(m_system.surface(), m_rho, m_suspects);
    if (!separation_pays(forms)) return;
    const auto [a, b] = signed_eigenvalues(forms);
    const double gamma = forms.dirac(0, 0).w / forms.mass(0, 0).w;
    const double own = gamma - a < b - gamma ? a : b;
    m_is_mixed = std::abs(own - before) <= 0.03 * (b - a);
    m_is_doubtful = !m_is_mixed && companions.cols() == max_companions;
    if (m_is_mixed || m_is_doubtful) return;
    before = own;
    // The vector of smallest energy in the span of more companions is nearer to an eigenvector.
    const Quaternion_vector<double> last = companions.col(companions.cols() - 1);
    const Vectors source = block_operator(m_system.areas())(last);
    companions = side_by_side(companions, companion(v, source.col(0)));
  }
}

template <class SolverTraits, class EigensolverTraits>
bool Dirac_search<SolverTraits, EigensolverTraits>::stays_separated(
    const Quaternion_vector<double>& v, const Quaternion_vector<double>& start,
    double separation) const
{
  return separation > 0 && m_system.overlap(v, start) > 0.97 &&
         std::abs(dirac_quotient(m_system.surface(), m_rho, v)) < 0.1 * separation;
}

template <class SolverTraits, class EigensolverTraits>
bool Dirac_search<SolverTraits, EigensolverTraits>::another_may_be_nearer(
    const Quaternion_vector<double>& v) const
{
  const double overlap = m_system.overlap(v, m_guide);
  return overlap < same_branch && overlap * overlap + same_branch * same_branch <= 1;
}

template <class SolverTraits, class EigensolverTraits>
Eigensolver_result Dirac_search<SolverTraits, EigensolverTraits>::smallest(
    Vectors start, int wanted, double tolerance, int max_iterations,
    const Go_further& go_further) const
{
  Eigensolver_options options;
  options.wanted = wanted;
  options.tolerance = tolerance;
  options.max_iterations = max_iterations;
  options.scale = std::sqrt(m_system.unit());
  return EigensolverTraits()(m_system.matrix(), m_system.areas(), m_system.solver(),
                             std::move(start), options, go_further);
}

template <class SolverTraits, class EigensolverTraits>
auto Dirac_search<SolverTraits, EigensolverTraits>::companion(
    const Quaternion_vector<double>& v, const Quaternion_vector<double>& b) const -> Vectors
{
  Vectors u;
  inverse_operator(m_system.solver())(Vectors(b), u);
  return without(v, u.col(0));
}

template <class SolverTraits, class EigensolverTraits>
auto Dirac_search<SolverTraits, EigensolverTraits>::with_lowest(const Quaternion_vector<double>& v,
                                                                Vectors companions) const -> Vectors
{
  Ritz_panel space = make_panel(block_operator(m_system.matrix()), block_operator(m_system.areas()),
                                std::move(companions));
  orthonormalize(space);
  if (space.size() == 0) return v;
  const auto ritz = hermitian_jacobi(gram_matrix(space.v, space.kv));
  return side_by_side(v, combination(space.v, Vectors(ritz.vectors.leftCols(1))));
}

template <class SolverTraits, class EigensolverTraits>
auto Dirac_search<SolverTraits, EigensolverTraits>::without(
    const Quaternion_vector<double>& v, const Quaternion_vector<double>& u) const -> Vectors
{
  Vectors rest = u;
  const Quaternion<double> along = inner_product(v, m_system.areas(), u) / m_system.squared_norm(v);
  add_multiple(rest.col(0), v, -along);
  return rest;
}

template <class SolverTraits, class EigensolverTraits>
auto Dirac_search<SolverTraits, EigensolverTraits>::side_by_side(const Vectors& a, const Vectors& b)
    -> Vectors
{
  Vectors both(a.rows(), a.cols() + b.cols());
  both << a, b;
  return both;
}

}  // namespace internal
}  // namespace Conformal_geometry_processing

#ifndef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
namespace Conformal_geometry_processing {

extern template class internal::Dirac_search<Default_solver_traits, Lobpcg_eigensolver_traits>;

}  // namespace Conformal_geometry_processing
#endif

#endif
