// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>
#include <Quaternionic_linear_algebra/dense/Solver_status.h>
#include <Quaternionic_linear_algebra/direct/Ordering.h>
#include <Quaternionic_linear_algebra/direct/Solver_ref.h>

#include <memory>
#include <utility>

namespace Conformal_geometry_processing::internal {

/// \brief Solves L x = b for a real, positive semidefinite L whose kernel consists of the
/// constants, such as the cotan Laplacian of a connected mesh.
///
/// Replaces row and column 0 by those of the identity, which makes the matrix definite without
/// changing its pattern, so that the ordering can be shared with other matrices of the mesh. The
/// solution does not depend on the choice of the row.
///
/// Every function throws `Solver_error` if the solver fails.
class Grounded_solver {
 public:
  /// Computes an ordering
  explicit Grounded_solver(std::shared_ptr<const Sparse_pattern> pattern,
                           const Spin_solvers& solvers = {});

  /// Uses another solver like one for the same pattern, and shares its analysis
  template <class Scalar>
  Grounded_solver(std::shared_ptr<const Sparse_pattern> pattern, const Solver_ref<Scalar>& other)
      : m_grounded(std::move(pattern)), m_solver(other.template another<double>())
  {
    check("analysis", m_solver.analyze_like(m_grounded.pattern(), other));
  }

  /// Solves with the grounded matrix
  const Solver_ref<double>& solver() const { return m_solver; }

  const Ordering& ordering() const { return m_solver.ordering(); }
  Solver_statistics statistics() const { return m_solver.statistics(); }

  /// \brief Factors L; may be called repeatedly, for matrices with the same pattern.
  /// \pre the pattern of L is the one given to the constructor; the rows of L sum to zero, and the
  /// graph of L is connected
  void factorize(const Hermitian_sparse_matrix<double>& L);

  /// \brief Returns the solutions x with mean zero, one for each column of b.
  ///
  /// L x = b is solvable only if b sums to zero; the constant component of b, which is outside the
  /// range of L, is removed: x minimizes |L x - b|.
  Block<double> solve(Block<double> b) const;

 private:
  static void check(const char* step, Solver_status status);

  Hermitian_sparse_matrix<double> m_grounded;
  Solver_ref<double> m_solver;
};

}  // namespace Conformal_geometry_processing::internal
