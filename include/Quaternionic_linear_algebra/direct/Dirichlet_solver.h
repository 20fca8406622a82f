// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>
#include <Quaternionic_linear_algebra/dense/Solver_status.h>
#include <Quaternionic_linear_algebra/direct/Solver_ref.h>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \brief Solves A x = b with Dirichlet conditions: x is prescribed on some rows, and the equation
/// holds on all others.
///
/// Replaces rows and columns of the prescribed unknowns by those of the identity, so that the
/// pattern does not change and the analysis can be shared with other matrices of the mesh. Every
/// function throws `Solver_error` if the solver fails.
///
/// Instead, unknowns can be attached to their values by weights: x then minimises
/// <x, A x>/2 - <b, x> + sum w_i |x_i - v_i|^2/2, and A must be positive definite together with w.
/// \tparam Scalar numbers or quaternions
template <class Scalar>
class Dirichlet_solver {
 public:
  using Matrix = Hermitian_sparse_matrix<Scalar>;

  /// \param given the rows whose unknowns are prescribed, in any order
  Dirichlet_solver(std::shared_ptr<const Sparse_pattern> pattern, const std::vector<int>& given,
                   const Spin_solvers& solvers = {});

  /// Uses another solver like one for the same pattern, and shares its analysis
  template <class OtherScalar>
  Dirichlet_solver(std::shared_ptr<const Sparse_pattern> pattern, const std::vector<int>& given,
                   const Solver_ref<OtherScalar>& other)
      : Dirichlet_solver(given, std::move(pattern), other.template another<Scalar>())
  {
    check("analysis", m_solver.analyze_like(m_matrix.pattern(), other));
  }

  bool is_given(int i) const { return m_is_given[static_cast<std::size_t>(i)] != 0; }

  /// \brief Factors A; may be called repeatedly, for matrices with the same pattern.
  /// \pre A is positive definite on the rows that are not given
  void factorize(const Matrix& A);

  /// \brief Factors A + w, with w >= 0 on all rows: attaches unknowns instead of prescribing them.
  void factorize(const Matrix& A, Eigen::VectorXd w);

  /// \brief Returns x with A x = b on the free rows and x = values on the others, for all columns.
  /// \param A the matrix that was factorized
  /// \param b, values all rows; only the free rows of `b` and the other rows of `values` are used
  Block<Scalar> solve(const Matrix& A, const Block<Scalar>& b, const Block<Scalar>& values) const;

 private:
  Dirichlet_solver(const std::vector<int>& given, std::shared_ptr<const Sparse_pattern> pattern,
                   Solver_ref<Scalar> solver);
  static void check(const char* step, Solver_status status);

  Matrix m_matrix;
  std::vector<char> m_is_given;
  Eigen::VectorXd m_weights;  // empty: unknowns are prescribed
  Solver_ref<Scalar> m_solver;
};

}  // namespace Conformal_geometry_processing::internal
