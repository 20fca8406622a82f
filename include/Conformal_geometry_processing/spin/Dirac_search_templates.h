// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_SEARCH_TEMPLATES_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_SEARCH_TEMPLATES_H

#include <Conformal_geometry_processing/mesh/Delaunay_view.h>
#include <Conformal_geometry_processing/operators/dirac_forms.h>
#include <Conformal_geometry_processing/spin/Dirac_search.h>
#include <Conformal_geometry_processing/spin/rayleigh_ritz_of_dirac.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Conformal_geometry_processing {
namespace internal {

template <class Problem>
Dirac_search<Problem>::Dirac_search(const Problem& problem, const Curvature_potential& rho,
                                    const Quaternion_vector<double>& guide,
                                    const Dirac_options& options, const Go_further& go_further)
    : m_problem(problem), m_rho(rho), m_guide(guide), m_options(options), m_go_further(go_further)
{}

template <class Problem>
void Dirac_search<Problem>::run(const Quaternion_vector<double>& start, double separation)
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
    two_columns(m_problem.start(v, m_options.random_seed));
  else if (another_may_be_nearer(v))
    two_columns(m_problem.with_rest(v, m_guide));
}

template <class Problem>
void Dirac_search<Problem>::one_column(const Vectors& start, double separation)
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

template <class Problem>
void Dirac_search<Problem>::two_columns(const Vectors& start)
{
  if (!iterate(start, 2, (std::max)(m_options.tolerance, rough), m_go_further)) return;
  m_is_cancelled = m_result.cancelled;
  if (is_cancelled()) return;
  m_is_mixed = separation_pays(dirac_forms(m_problem.mesh(), m_rho, m_result.vectors));
  m_suspects = m_result.vectors;
  if (is_mixed()) return;
  const bool first = m_problem.overlap(m_suspects.col(0), m_guide) >=
                     m_problem.overlap(m_suspects.col(1), m_guide);
  if (iterate(m_suspects, first ? 1 : 2, m_options.tolerance, m_go_further))
    m_is_cancelled = m_result.cancelled;
}

template <class Problem>
void Dirac_search<Problem>::judge(const Quaternion_vector<double>& v, double mu)
{
  m_is_judged = true;
  const Quaternion_vector<double> image = apply_dirac_form(m_problem.mesh(), m_rho, v);
  // Nearer to zero than the quotient, for averages are shorter: so this claims less.
  const double least = inner_product(v, image).w / m_problem.squared_norm(v);
  if (is_surely_unmixed(least, mu)) return;
  Vectors companions = m_problem.companion(v, image);
  double before = std::numeric_limits<double>::infinity();
  while (true) {
    m_suspects = m_problem.with_lowest(v, companions);
    if (m_suspects.cols() == 1) return;
    const Dirac_forms forms = dirac_forms(m_problem.mesh(), m_rho, m_suspects);
    if (!separation_pays(forms)) return;
    const auto [a, b] = signed_eigenvalues(forms);
    const double gamma = forms.dirac(0, 0).w / forms.mass(0, 0).w;
    const double own = gamma - a < b - gamma ? a : b;
    m_is_mixed = std::abs(own - before) <= 0.03 * (b - a);
    m_is_doubtful = !m_is_mixed && companions.cols() == max_companions;
    if (m_is_mixed || m_is_doubtful) return;
    before = own;
    m_problem.add_companion(v, companions);
  }
}

template <class Problem>
bool Dirac_search<Problem>::stays_separated(const Quaternion_vector<double>& v,
                                            const Quaternion_vector<double>& start,
                                            double separation) const
{
  return separation > 0 && m_problem.overlap(v, start) > 0.97 &&
         std::abs(dirac_quotient(m_problem.mesh(), m_rho, v)) < 0.1 * separation;
}

template <class Problem>
bool Dirac_search<Problem>::another_may_be_nearer(const Quaternion_vector<double>& v) const
{
  const double overlap = m_problem.overlap(v, m_guide);
  return overlap < same_branch && overlap * overlap + same_branch * same_branch <= 1;
}

}  // namespace internal
}  // namespace Conformal_geometry_processing

#ifndef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
namespace Conformal_geometry_processing {

extern template class internal::Dirac_search<
    Dirac_eigenproblem<Default_solver_traits, Lobpcg_eigensolver_traits, Mesh_view>>;
extern template class internal::Dirac_search<
    Dirac_eigenproblem<Default_solver_traits, Lobpcg_eigensolver_traits, Delaunay_view>>;

}  // namespace Conformal_geometry_processing
#endif

#endif
