// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_KRYLOV_REFACTORIZATION_RULE_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_KRYLOV_REFACTORIZATION_RULE_H

#include <Conformal_geometry_processing/linear_algebra/dense/Solver_status.h>

#include <algorithm>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief what a factorization costs, in passes through the factor, each of which solves for four
/// numbers per row at once.
///
/// Measured with the library's own solvers on spheres of 4,000 to 262,000 vertices with AVX2: real
/// 2.9 to 4.5, quaternionic 6.2 to 10.3, with factors in single precision 5.5 to 8.8. Other solvers
/// factor at a lower rate, and would gain from keeping the factor still longer.
/// \param components of a scalar: 4 of a quaternion
double factorization_price(const Solver_statistics& s, int components);

/// \ingroup PkgLinearAlgebra
/// \brief decides when an old factorization costs more than a new one, from counted solves.
///
/// The matrix changes from step to step. An old factorization saves the price of a new one and
/// costs more solves than a step with a new one does. As with any machine that wears, it is best
/// replaced when the last step cost more than the average of all steps since it was made, its own
/// price included: never, if the costs stay below the price; at the optimum, if they grow evenly.
/// No step may cost more than a factorization on top. One that would ends with a new one in its
/// midst, and the steps after it begin with new ones: one step the first time, then two, four, ...
/// until an old one has served again. Counts only and no clocks, so that runs are repeatable.
class Refactorization_rule {
 public:
  /// \param price what a factorization costs, in solves
  void set_price(double price) { m_price = price; }
  double price() const { return m_price; }

  /// \brief a step with another matrix begins.
  /// \returns true if it should have a factorization of its own; `renewed()` then tells that it has
  bool begin_step();

  /// the matrix of this step has been factorized
  void renewed();

  /// the same, after the old factorization has been tried in this step
  void renewed_in_the_midst();

  /// counts solves of this step
  void add(double solves) { m_solves += solves; }

  /// \brief the solves that are left to this step before a factorization would have been cheaper.
  /// \pre the factorization is older than the step
  double budget() const { return m_price + m_fresh - m_solves; }

 private:
  // what the old factorization has cost in this step beyond a new one
  double extra() const { return m_age == 0 ? 0 : (std::max)(m_solves - m_fresh, 0.); }

  double m_price = 0;
  int m_age = 0;         // steps since the one that was factorized
  double m_solves = 0;   // in this step
  double m_fresh = 0;    // in the last step with a factorization of its own
  double m_earlier = 0;  // extra solves in the steps of this age before this one
  int m_pauses_left = 0, m_pause = 1;
};

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/linear_algebra/krylov/Refactorization_rule_impl.h>
#endif

#endif
