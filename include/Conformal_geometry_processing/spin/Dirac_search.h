// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_SEARCH_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_SEARCH_H

#include <Conformal_geometry_processing/linear_algebra/krylov/Eigensolver_result.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/Lobpcg.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

namespace internal {

/// Among the smallest eigenvectors of X for one potential, those in question as the continuation
/// of a guide; and whether X has mixed them.
///
/// One column is enough where it converges to the branch of the guide. As soon as it is rough, its
/// companion tells whether X has mixed it with a vector of opposite sign.
template <class SolverTraits, class EigensolverTraits>
class Dirac_search {
  using System = Dirac_system<SolverTraits>;
  using Vectors = Block<Quaternion<double>>;
  static constexpr int max_companions = 5;
  static constexpr double rough = 1e-2;  // an error estimate: exact enough to see mixtures

 public:
  /// squares of overlaps with orthogonal vectors add up to at most one: where one is 0.75, every
  /// other is below 0.67
  static constexpr double same_branch = 0.75;

  /// \param system has the potential rho
  /// \param options those of the whole solve, with the tolerance of this search
  Dirac_search(const System& system, const Curvature_potential& rho,
               const Quaternion_vector<double>& guide, const Dirac_options& options,
               const Go_further& go_further);

  /// \param start where to begin
  /// \param separation the distance of the eigenvalues of `start` and the vector that it has been
  /// separated from, if it has: rho is shifted so that its own is zero
  void run(const Quaternion_vector<double>& start, double separation = 0);

  /// vectors with values and estimates: one or two columns
  Eigensolver_result& result() { return m_result; }
  int iterations() const { return m_iterations; }
  bool is_cancelled() const { return m_is_cancelled; }

  /// a vector, and that which X has mixed it with, exact enough to separate them
  bool is_mixed() const { return m_is_mixed; }
  const Vectors& mixture() const { return m_suspects; }

 private:
  void one_column(const Vectors& start, double separation);

  /// The two smallest, first as exact as it takes to see whether X has mixed them; if not, the
  /// nearer one to the tolerance.
  void two_columns(const Vectors& start);

  /// Returns false, and does nothing, when the iterations are used up.
  template <class Watch>
  bool iterate(const Vectors& start, int wanted, double tolerance, Watch& watch)
  {
    const int left = m_options.max_iterations - m_iterations;
    if (left <= 0 && m_result.vectors.cols() > 0) return false;
    m_result = smallest(start, wanted, tolerance, left, watch);
    m_iterations += m_result.iterations;
    return true;
  }

  /// the smallest eigenpairs of X, as many as `start` has columns; `wanted` of them converge
  Eigensolver_result smallest(Vectors start, int wanted, double tolerance, int max_iterations,
                              const Go_further& go_further) const;

  /// \brief whether X has mixed v, of energy mu.
  ///
  /// Its companion holds the other mixture and some error, which is mostly of large energy: more
  /// companions take that out. Seen without them, there is no mixture either.
  void judge(const Quaternion_vector<double>& v, double mu);

  /// \brief whether v is a vector once separated, and not mixed again by the shifted X.
  ///
  /// Now its eigenvalue is zero. In a mixture of eigenvalues a and b it is zero where the angle has
  /// the squared tangent |a / b|: for a mixture that counts, from 24 degrees on. Within 14 degrees
  /// of an unmixed vector there is none.
  bool stays_separated(const Quaternion_vector<double>& v, const Quaternion_vector<double>& start,
                       double separation) const;

  /// \brief the component of X^-1 b orthogonal to v, |V| x 1.
  ///
  /// Where b is the signed form applied to v, X^-1 b is (D - rho)^-1 v on smooth vectors. If v is a
  /// mixture of two eigenvectors of D - rho, this companion of v contains the other mixture of
  /// them, besides the discretisation error; otherwise only that error.
  Vectors companion(const Quaternion_vector<double>& v, const Quaternion_vector<double>& b) const;

  /// \brief [v, w], |V| x 2, where w is the vector of smallest energy in the span of `companions`;
  /// v alone if they are zero
  Vectors with_lowest(const Quaternion_vector<double>& v, Vectors companions) const;

  /// u without its component along v
  Vectors without(const Quaternion_vector<double>& v, const Quaternion_vector<double>& u) const;

  static Vectors side_by_side(const Vectors& a, const Vectors& b);

  /// v is not on the branch, and leaves room for a vector that is
  bool another_may_be_nearer(const Quaternion_vector<double>& v) const;

  const System& m_system;
  const Curvature_potential& m_rho;
  const Quaternion_vector<double>& m_guide;
  const Dirac_options m_options;
  const Go_further& m_go_further;
  Eigensolver_result m_result;
  Vectors m_suspects;
  int m_iterations = 0;
  bool m_is_judged = false, m_is_mixed = false, m_is_doubtful = false, m_is_cancelled = false;
};

}  // namespace internal

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/spin/Dirac_search_templates.h>
#endif

#endif
