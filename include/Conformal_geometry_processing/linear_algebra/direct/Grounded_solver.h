// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_GROUNDED_SOLVER_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_GROUNDED_SOLVER_H

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/linear_algebra/dense/Solver_status.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Default_solver_traits.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Ordering.h>

#include <memory>
#include <string>
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
  explicit Grounded_solver(std::shared_ptr<const Sparse_pattern> pattern)
      : m_grounded(std::move(pattern))
  {
    check("analysis", m_solver.analyze(m_grounded.pattern()));
  }

  /// uses a given one
  Grounded_solver(std::shared_ptr<const Sparse_pattern> pattern, const Ordering& order)
      : m_grounded(std::move(pattern))
  {
    check("analysis", m_solver.analyze(m_grounded.pattern(), order));
  }

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
  void factorize(const Hermitian_sparse_matrix<double>& L)
  {
    if (!(L.pattern() == m_grounded.pattern()))
      throw Solver_error("Grounded_solver::factorize", to_string(Solver_status::wrong_state));
    for (int k = 0; k < L.pattern().size_of_entries(); ++k) m_grounded.value(k) = L.value(k);
    // Column 0 of the lower triangle is all there is of row and column 0. Times zero, and not zero:
    // a value that is not finite must not go unnoticed.
    for (int k = 0; k < L.pattern().offsets[1]; ++k) m_grounded.value(k) *= 0;
    m_grounded.value(0) += 1;
    check("factorization", m_solver.factorize(m_grounded, {}));
  }

  /// \brief the solutions x with mean zero, one for each column of b.
  ///
  /// L x = b has a solution only if b sums to zero; the mean of b, which no x could bring forth, is
  /// taken off before: x minimises |L x - b|.
  Block<double> solve(Block<double> b) const
  {
    const Eigen::RowVectorXd unreachable = b.colwise().mean();
    b.rowwise() -= unreachable;
    b.row(0).setZero();
    Block<double> x;
    check("solution", m_solver.solve(b, x));
    const Eigen::RowVectorXd mean = x.colwise().mean();
    x.rowwise() -= mean;
    return x;
  }

 private:
  static void check(const char* step, Solver_status status)
  {
    if (status != Solver_status::success)
      throw Solver_error("Grounded_solver", std::string(step) + " of the grounded matrix failed: " +
                                                to_string(status));
  }

  Hermitian_sparse_matrix<double> m_grounded;
  Solver m_solver;
};

}  // namespace Conformal_geometry_processing

#endif
