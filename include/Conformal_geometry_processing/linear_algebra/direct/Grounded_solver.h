// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_GROUNDED_SOLVER_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_GROUNDED_SOLVER_H

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/linear_algebra/dense/Solver_status.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Default_solver_traits.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Ordering.h>

#include <memory>
#include <utility>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief solves L x = b where L is real, positive semidefinite and kills just the constants, as
/// the cotan Laplacian of a connected mesh does.
///
/// Row and column 0 are replaced by those of the identity, so the matrix becomes definite on
/// the same pattern, and may share the ordering of other matrices of the mesh. The solution does
/// not depend on which row it is.
///
/// Every function throws `Solver_error` where the solver fails.
/// \tparam SolverTraits a model of `SparseHermitianSolverTraits`
template <class SolverTraits = Default_solver_traits>
class Grounded_solver {
 public:
  /// chooses an ordering
  explicit Grounded_solver(std::shared_ptr<const Sparse_pattern> pattern);

  /// uses a given one
  Grounded_solver(std::shared_ptr<const Sparse_pattern> pattern, const Ordering& order);

  /// shares the analysis of another solver of the same traits and pattern
  /// \tparam OtherSolver a model of `SparseHermitianSolver`
  template <class OtherSolver, class = typename OtherSolver::Scalar>
  Grounded_solver(std::shared_ptr<const Sparse_pattern> pattern, const OtherSolver& other)
      : m_grounded(std::move(pattern))
  {
    check("analysis", m_solver.analyze_like(m_grounded.pattern(), other));
  }

  using Solver = typename SolverTraits::template Solver<double>;

  /// solves with the grounded matrix
  const Solver& solver() const { return m_solver; }

  const Ordering& ordering() const { return m_solver.ordering(); }
  Solver_statistics statistics() const { return m_solver.statistics(); }

  /// \brief done any number of times, for matrices on the pattern.
  /// \pre the pattern of L is the one given to the constructor; the rows of L sum to zero, and the
  /// graph of L is connected
  void factorize(const Hermitian_sparse_matrix<double>& L);

  /// \brief the solutions x with mean zero, one for each column of b.
  ///
  /// L x = b has a solution only if b sums to zero; the mean of b, which no x could bring forth, is
  /// taken off before: x minimises |L x - b|.
  Block<double> solve(Block<double> b) const;

 private:
  static void check(const char* step, Solver_status status);

  Hermitian_sparse_matrix<double> m_grounded;
  Solver m_solver;
};

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/linear_algebra/direct/Grounded_solver_templates.h>
#endif

#endif
