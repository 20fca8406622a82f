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

/// Finds the candidates for the continuation of a guide among the smallest eigenvectors of X for
/// one potential, and detects whether X has mixed them.
///
/// One column suffices if it converges to the branch of the guide. Once its error estimate is below
/// `rough`, its companion shows whether X has mixed it with a vector of opposite sign.
template <class SolverTraits, class EigensolverTraits>
class Dirac_search {
  using System = Dirac_system<SolverTraits>;
  using Vectors = Block<Quaternion<double>>;
  static constexpr int max_companions = 5;
  static constexpr double rough = 1e-2;  // error estimate below which mixtures can be detected

 public:
  /// squared overlaps with orthogonal vectors sum to at most one: if one overlap is 0.75, every
  /// other is below 0.67
  static constexpr double same_branch = 0.75;

  /// \param system has the potential rho
  /// \param options options of the whole solve, with the tolerance of this search
  Dirac_search(const System& system, const Curvature_potential& rho,
               const Quaternion_vector<double>& guide, const Dirac_options& options,
               const Go_further& go_further);

  /// \param start start vectors
  /// \param separation if `start` has been separated from another vector, the distance of their
  /// eigenvalues: rho is then shifted so that the eigenvalue of `start` is zero
  void run(const Quaternion_vector<double>& start, double separation = 0);

  /// one or two vectors with their values and error estimates
  Eigensolver_result& result() { return m_result; }
  int iterations() const { return m_iterations; }
  bool is_cancelled() const { return m_is_cancelled; }

  /// whether the result is a vector and the one that X has mixed it with, exact enough to separate
  /// them
  bool is_mixed() const { return m_is_mixed; }
  const Vectors& mixture() const { return m_suspects; }

 private:
  void one_column(const Vectors& start, double separation);

  /// Computes the two smallest eigenvectors, first only as exactly as detecting a mixture requires;
  /// without a mixture, then iterates the one nearer to the guide to the tolerance.
  void two_columns(const Vectors& start);

  /// Returns false and does nothing if the iterations are used up.
  template <class Watch>
  bool iterate(const Vectors& start, int wanted, double tolerance, Watch& watch)
  {
    const int left = m_options.max_iterations - m_iterations;
    if (left <= 0 && m_result.vectors.cols() > 0) return false;
    m_result = smallest(start, wanted, tolerance, left, watch);
    m_iterations += m_result.iterations;
    return true;
  }

  /// the smallest eigenpairs of X, one for each column of `start`; `wanted` of them converge
  Eigensolver_result smallest(Vectors start, int wanted, double tolerance, int max_iterations,
                              const Go_further& go_further) const;

  /// \brief decides whether X has mixed v, whose energy is mu.
  ///
  /// The companion of v contains the other mixture and an error, mostly of high energy, which
  /// further companions remove. If no mixture is visible without them, there is none.
  void judge(const Quaternion_vector<double>& v, double mu);

  /// \brief whether v, which has been separated, is not mixed again by the shifted X.
  ///
  /// The eigenvalue of v is now zero. A mixture of the eigenvalues a and b has the quotient zero if
  /// the squared tangent of its angle is |a / b|; for a mixture that matters, the angle is at least
  /// 24 degrees. Within 14 degrees of an unmixed vector there is no mixture.
  bool stays_separated(const Quaternion_vector<double>& v, const Quaternion_vector<double>& start,
                       double separation) const;

  /// \brief the component of X^-1 b orthogonal to v, |V| x 1.
  ///
  /// If b is the signed form applied to v, X^-1 b is (D - rho)^-1 v on smooth vectors. If v is a
  /// mixture of two eigenvectors of D - rho, this companion of v contains the other mixture of them
  /// and the discretisation error; otherwise only that error.
  Vectors companion(const Quaternion_vector<double>& v, const Quaternion_vector<double>& b) const;

  /// \brief [v, w], |V| x 2, where w is the vector of smallest energy in the span of `companions`;
  /// v alone if they are zero
  Vectors with_lowest(const Quaternion_vector<double>& v, Vectors companions) const;

  /// u without its component along v
  Vectors without(const Quaternion_vector<double>& v, const Quaternion_vector<double>& u) const;

  static Vectors side_by_side(const Vectors& a, const Vectors& b);

  /// whether v is not on the branch and its overlap is small enough for another vector to be on it
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
