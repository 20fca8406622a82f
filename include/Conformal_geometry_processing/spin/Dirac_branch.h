// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/spin/Dirac_solution.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>
#include <Conformal_geometry_processing/spin/follow_branch.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>
#include <Quaternionic_linear_algebra/dense/block_operators.h>
#include <Quaternionic_linear_algebra/krylov/Eigensolver_result.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace Conformal_geometry_processing::internal {

/// \brief solves (D - rho) lambda = gamma lambda on a closed surface, on the branch of eigenpairs
/// of D - t rho from lambda = 1 at t = 0 to t = 1 [CGP (5.3)].
///
/// The thesis takes the eigenvalue of smallest modulus: for strong rho, or rho of large mean, that
/// is on another branch. Here each stage
/// 1. factors X at a point (t, sigma), the pole; first at t = 1, with the mean of rho removed;
/// 2. extends the span of 1 by images under X^-1 H, which resemble (D - rho)^-1 on smooth vectors,
///    so that few of them suffice for the eigenvectors near the pole;
/// 3. follows the branch within the span as far as the span can be trusted: as far as the vector
///    turns little (`follow_branch()`), or the span is found to contain it
///    (`follow_settled_branch()`);
/// 4. refines the vector there. Normally t is 1 and the factor of the first stage still serves as
///    preconditioner; if not, that point is the next pole;
/// 5. compares the eigenpair with the one that was predicted. If it is another, the span is not
///    trusted that far again.
///
/// The result is stationary for vector and shift together: lambda is the smallest eigenvector of
/// the energy X of rho + gamma, with gamma its own quotient. Therefore rho and rho + c have the
/// same lambda, also on coarse meshes.
///
/// Costs one factorization for weak rho, two where gamma is far from minus the mean of rho, and
/// one more for each stage.
class Dirac_branch {
  using System = Dirac_system;
  using Vectors = Block<Quaternion<double>>;

 public:
  /// \param system the system of a closed surface; must outlive the object, as the others must
  /// \param[out] s receives the solution, or what was reached if it has not converged
  Dirac_branch(System& system, const Curvature_potential& rho, const Dirac_options& options,
               Dirac_solution& s, const Go_further& go_further);

  void solve();

 private:
  /// \brief vectors of the span, which bounds the dense work of a stage.
  ///
  /// A stage begins with ten at most, and adds four whenever another end is tried, to which the way
  /// is at most half as long: beyond these, the shorter way helps, not more vectors.
  static constexpr Eigen::Index most_vectors = 20;

  /// least overlap of two approximations of one eigenvector
  static constexpr double same_vector = 0.85;

  /// t rho + sigma
  Curvature_potential potential(double t, double sigma) const;

  /// factors X there
  void place_pole(double t, double sigma);

  /// whether the factor at hand is a good preconditioner at the point
  bool is_near_pole(const Branch_point& p) const;

  /// \brief whether a stage seems to have left its branch: the eigenvalue at its end is not what
  /// its derivatives at both ends, which are means of -rho, lead to.
  ///
  /// A rough span couples branches that cross, and may turn off without a jump of its vectors.
  /// Short stages count as right, because branches that repel each other do bend.
  /// The vector at `to` is the present one.
  bool turns_off(const Branch_point& from, const Branch_point& to) const;

  /// \brief whether the present vector and its eigenvalue are those that the span predicted.
  ///
  /// Where the span contains the branch, it predicts eigenvalues up to the square of its error.
  bool is_as_predicted(const Branch_point& from, const Branch_point& predicted,
                       const Branch_point& to) const;

  /// the vector of a point on the branch, which the span contains
  Quaternion_vector<double> in_span(const Branch_point& p) const
  {
    return combination(m_span, Vectors(p.c)).col(0);
  }

  /// adds a vector to the span, unless it is in it
  bool add(Quaternion_vector<double> v);

  /// adds the next `words` images of the last vector, as long as there is room for them
  void extend(int words);

  /// keeps only the identity and the last vectors: those of earlier stages describe D - t rho for
  /// other t
  void forget_early_vectors();

  /// the end of a stage that begins at `first`: on its branch, as near to `end` as the span can be
  /// trusted, which is extended if necessary
  /// \param first receives the coefficients of the present vector
  Branch_point predict(Branch_point& first, double end);

  /// \brief makes s.lambda the eigenvector near its present value at p.t, and p.gamma its
  /// eigenvalue.
  ///
  /// The shift has to be the quotient of its own eigenvector. It follows the quotient of the
  /// iterates (`follow_quotient()`) by the secant method, which goes on from one eigenvector to the
  /// next where the iterates do not suffice.
  void refine(Branch_point& p, double tolerance);

  /// the eigenvalue of lambda less the shift of X, at.gamma
  double quotient_change(const Branch_point& at, const Quaternion_vector<double>& lambda) const
  {
    return dirac_quotient(m_system.surface(), potential(at.t, at.gamma), lambda);
  }

  /// the change up to which a shift counts as the quotient of its eigenvector, in 1/length
  double stationary(double tolerance) const { return tolerance * std::sqrt(m_system.unit()); }

  /// adds the change to the shift, but at most a quarter of the gap
  void move(Branch_point& at, double change) const
  {
    at.gamma += std::clamp(change, -at.least_gap / 4, at.least_gap / 4);
  }

  /// the eigenvector of X, which is assembled; factors X there if the factor at hand is too far
  /// away. at.gamma is the shift, before and after.
  void iterate(Branch_point& at, double tolerance);

  /// the smallest eigenvector of X, which is assembled, from s.lambda
  void smallest(Branch_point& at, double tolerance);

  /// \brief moves the shift towards the quotient of an iterate and assembles X there; returns
  /// whether it has.
  ///
  /// Ends when a change is not smaller than the one before: a matrix that keeps moving would only
  /// delay the eigenvector.
  bool follow_quotient(Branch_point& at, double tolerance, const Eigensolver_progress& iterate);

  void conclude(const Branch_point& p);

  System& m_system;
  const Curvature_potential& m_rho;
  const Dirac_options& m_options;
  Dirac_solution& m_s;
  const Go_further& m_go_further;
  Vectors m_span;     // orthonormal with respect to the vertex areas
  Dirac_gram m_gram;  // of the span, without the vectors added since the last prediction
  Branch_point m_pole;
  Shift_secant m_secant;
  bool m_follows_quotient = false;
  bool m_may_settle = true;  // no stage that relied on it has been rejected
};

}  // namespace Conformal_geometry_processing::internal
