// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_DIRICHLET_SOLVER_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_DIRICHLET_SOLVER_H

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/linear_algebra/dense/Solver_status.h>
#include <Conformal_geometry_processing/linear_algebra/dense/block_operators.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Default_solver_traits.h>

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief solves A x = b on some rows, where x is given on all others: Dirichlet conditions.
///
/// Rows and columns of the given unknowns are replaced by those of the identity, so the pattern
/// stays, and may share the analysis of other matrices of the mesh. Every function throws
/// `Solver_error` where the solver fails.
/// \tparam Scalar numbers or quaternions
/// \tparam SolverTraits a model of `SparseHermitianSolverTraits`
template <class Scalar, class SolverTraits = Default_solver_traits>
class Dirichlet_solver {
 public:
  using Solver = typename SolverTraits::template Solver<Scalar>;
  using Matrix = Hermitian_sparse_matrix<Scalar>;

  /// \param given the rows whose unknowns are given, in any order
  Dirichlet_solver(std::shared_ptr<const Sparse_pattern> pattern, const std::vector<int>& given)
      : Dirichlet_solver(given, std::move(pattern))
  {
    check("analysis", m_solver.analyze(m_matrix.pattern()));
  }

  /// shares the analysis of another solver of the same traits and pattern
  /// \tparam OtherSolver a model of `SparseHermitianSolver`
  template <class OtherSolver, class = typename OtherSolver::Scalar>
  Dirichlet_solver(std::shared_ptr<const Sparse_pattern> pattern, const std::vector<int>& given,
                   const OtherSolver& other)
      : Dirichlet_solver(given, std::move(pattern))
  {
    check("analysis", m_solver.analyze_like(m_matrix.pattern(), other));
  }

  bool is_given(int i) const { return m_is_given[static_cast<std::size_t>(i)] != 0; }

  /// \brief done any number of times, for matrices on the pattern.
  /// \pre A is positive definite on the rows that are not given
  void factorize(const Matrix& A)
  {
    int k = 0;
    A.for_each_entry([&](int i, int j, const Scalar& a) {
      const bool is_free = !is_given(i) && !is_given(j);
      m_matrix.value(k++) = is_free ? a : Scalar_traits<Scalar>::from_real(i == j ? 1 : 0);
    });
    check("factorization", m_solver.factorize(m_matrix, {}));
  }

  /// \brief x with A x = b on the free rows and x = values on the others, for all columns.
  /// \param A the matrix that was factorized
  /// \param b, values all rows; of b those count that are free, of `values` the others
  Block<Scalar> solve(const Matrix& A, const Block<Scalar>& b, const Block<Scalar>& values) const
  {
    Block<Scalar> known = values, x;
    for (int i = 0; i < A.size(); ++i)
      if (!is_given(i)) known.row(i).setConstant(Scalar{});
    Block<Scalar> right = b - block_operator(A)(known);
    for (int i = 0; i < A.size(); ++i)
      if (is_given(i)) right.row(i) = values.row(i);
    check("solution", m_solver.solve(right, x));
    return x;
  }

 private:
  Dirichlet_solver(const std::vector<int>& given, std::shared_ptr<const Sparse_pattern> pattern)
      : m_matrix(std::move(pattern)), m_is_given(static_cast<std::size_t>(m_matrix.size()), 0)
  {
    for (int i : given) m_is_given[static_cast<std::size_t>(i)] = 1;
  }

  static void check(const char* step, Solver_status status)
  {
    if (status != Solver_status::success)
      throw Solver_error("Dirichlet_solver", std::string(step) + " failed: " + to_string(status));
  }

  Matrix m_matrix;
  std::vector<char> m_is_given;
  Solver m_solver;
};

}  // namespace Conformal_geometry_processing

#endif
