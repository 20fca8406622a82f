// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_SEARCH_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_SEARCH_H

#include <Conformal_geometry_processing/linear_algebra/krylov/Eigen_result.h>
#include <Conformal_geometry_processing/operators/dirac_forms.h>
#include <Conformal_geometry_processing/spin/Dirac_solution.h>
#include <Conformal_geometry_processing/spin/separate_signs.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace Conformal_geometry_processing {

namespace internal {

/// Among the smallest eigenvectors of X for one potential, those in question as the continuation
/// of a guide; and whether X has mixed them.
///
/// One column is enough where it converges to the branch of the guide. As soon as it is rough, its
/// companion tells whether X has mixed it with a vector of opposite sign.
template <class Problem>
class Dirac_search {
  using Vectors = Block<Quaternion<double>>;
  static constexpr int max_companions = 5;
  static constexpr double rough = 1e-2;  // an error estimate: exact enough to see mixtures

 public:
  /// squares of overlaps with orthogonal vectors add up to at most one: where one is 0.75, every
  /// other is below 0.67
  static constexpr double same_branch = 0.75;

  /// \param problem has the potential rho
  /// \param options those of the whole solve, with the tolerance of this search
  Dirac_search(const Problem& problem, const Curvature_potential& rho,
               const Quaternion_vector<double>& guide, const Dirac_options& options,
               const Go_further& go_further)
      : m_problem(problem), m_rho(rho), m_guide(guide), m_options(options), m_go_further(go_further)
  {}

  /// \param start where to begin
  /// \param separation the distance of the eigenvalues of `start` and the vector that it has been
  /// separated from, if it has: rho is shifted so that its own is zero
  void run(const Quaternion_vector<double>& start, double separation = 0)
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

  /// vectors with values and estimates: one or two columns
  Eigen_result& result() { return m_result; }
  int iterations() const { return m_iterations; }
  bool is_cancelled() const { return m_is_cancelled; }

  /// a vector, and that which X has mixed it with, exact enough to separate them
  bool is_mixed() const { return m_is_mixed; }
  const Vectors& mixture() const { return m_suspects; }

 private:
  void one_column(const Vectors& start, double separation)
  {
    bool is_enough = false;
    const auto watch = [&](const Eigen_progress& p) {
      if (p.vectors && p.estimate <= rough && !m_is_judged && separation == 0)
        judge(p.vectors->col(0), p.value);
      const bool is_slow = p.iteration >= 12 || (p.iteration >= 3 && p.estimate > 3 * rough);
      is_enough = is_slow || is_mixed() || m_is_doubtful;
      return !is_enough && m_go_further(p);
    };
    iterate(start, 1, m_options.tolerance, watch);
    m_is_cancelled = m_result.cancelled && !is_enough;
  }

  /// The two smallest, first as exact as it takes to see whether X has mixed them; if not, the
  /// nearer one to the tolerance.
  void two_columns(const Vectors& start)
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

  /// Returns false, and does nothing, when the iterations are used up.
  template <class Watch>
  bool iterate(const Vectors& start, int wanted, double tolerance, Watch& watch)
  {
    const int left = m_options.max_iterations - m_iterations;
    if (left <= 0 && m_result.vectors.cols() > 0) return false;
    m_result = m_problem.smallest(start, wanted, tolerance, left, watch);
    m_iterations += m_result.iterations;
    return true;
  }

  /// \brief whether X has mixed v, of energy mu.
  ///
  /// Its companion holds the other mixture and some error, which is mostly of large energy: more
  /// companions take that out. Seen without them, there is no mixture either.
  void judge(const Quaternion_vector<double>& v, double mu)
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

  /// \brief whether v is a vector once separated, and not mixed again by the shifted X.
  ///
  /// Now its eigenvalue is zero. In a mixture of eigenvalues a and b it is zero where the angle has
  /// the squared tangent |a / b|: for a mixture that counts, from 24 degrees on. Within 14 degrees
  /// of an unmixed vector there is none.
  bool stays_separated(const Quaternion_vector<double>& v, const Quaternion_vector<double>& start,
                       double separation) const
  {
    return separation > 0 && m_problem.overlap(v, start) > 0.97 &&
           std::abs(dirac_quotient(m_problem.mesh(), m_rho, v)) < 0.1 * separation;
  }

  /// v is not on the branch, and leaves room for a vector that is
  bool another_may_be_nearer(const Quaternion_vector<double>& v) const
  {
    const double overlap = m_problem.overlap(v, m_guide);
    return overlap < same_branch && overlap * overlap + same_branch * same_branch <= 1;
  }

  const Problem& m_problem;
  const Curvature_potential& m_rho;
  const Quaternion_vector<double>& m_guide;
  const Dirac_options m_options;
  const Go_further& m_go_further;
  Eigen_result m_result;
  Vectors m_suspects;
  int m_iterations = 0;
  bool m_is_judged = false, m_is_mixed = false, m_is_doubtful = false, m_is_cancelled = false;
};

}  // namespace internal

}  // namespace Conformal_geometry_processing

#endif
