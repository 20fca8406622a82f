// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_KRYLOV_REFACTORIZATION_RULE_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_KRYLOV_REFACTORIZATION_RULE_H

#include <Conformal_geometry_processing/linear_algebra/dense/Solver_status.h>

#include <algorithm>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief Returns the cost of a factorization, in passes through the factor, each of which solves
/// for four numbers per row at once.
///
/// Measured with the library's own solvers on spheres of 4,000 to 262,000 vertices with AVX2: real
/// 2.9 to 4.5, quaternionic 6.2 to 10.3, with factors in single precision 5.5 to 8.8. Other solvers
/// factor more slowly; for them it pays to keep the factor even longer.
/// \param components number of real components of a scalar: 4 for quaternions
double factorization_price(const Solver_statistics& s, int components);

namespace internal {

/// \ingroup PkgLinearAlgebra
/// \brief Decides when to refactor, from counted solves.
///
/// The matrix changes from step to step. An old factorization saves the price of a new one, but
/// needs more solves per step. As for any machine that wears, it is best replaced when the last
/// step cost more than the average of all steps since the factorization, whose price is included:
/// never, if the costs stay below the price; at the optimum, if they grow evenly. No step may
/// exceed its cost with a new factorization by more than the price of one. If it would, the step
/// refactors, and the steps after it begin with new factorizations: one step the first time, then
/// two, four, ... until an old one has served again. Uses counts instead of clocks, so that runs
/// are reproducible.
class Refactorization_rule {
 public:
  /// \param price cost of a factorization, in solves
  void set_price(double price) { m_price = price; }
  double price() const { return m_price; }

  /// \brief Begins a step with another matrix.
  /// \returns true if the step should refactor; `renewed()` is to be called afterwards
  bool begin_step();

  /// The matrix of this step has been factorized
  void renewed();

  /// The matrix has been factorized after the old factorization was tried in this step
  void renewed_in_the_midst();

  /// Counts solves of this step
  void add(double solves) { m_solves += solves; }

  /// \brief Solves left in this step until a factorization would have been cheaper.
  /// \pre the factorization is older than the step
  double budget() const { return m_price + m_fresh - m_solves; }

 private:
  // Extra cost of this step due to the old factorization
  double extra() const { return m_age == 0 ? 0 : (std::max)(m_solves - m_fresh, 0.); }

  double m_price = 0;
  int m_age = 0;         // steps since the last factorization
  double m_solves = 0;   // in this step
  double m_fresh = 0;    // in the last step with a factorization of its own
  double m_earlier = 0;  // extra solves in the steps of this age before this one
  int m_pauses_left = 0, m_pause = 1;
};

}  // namespace internal

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/linear_algebra/krylov/Refactorization_rule_impl.h>
#endif

#endif
