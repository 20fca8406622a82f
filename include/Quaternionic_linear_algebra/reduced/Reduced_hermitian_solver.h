// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>
#include <Quaternionic_linear_algebra/algebra/Reduced_basis.h>
#include <Quaternionic_linear_algebra/dense/block_operators.h>
#include <Quaternionic_linear_algebra/direct/Ordering.h>
#include <Quaternionic_linear_algebra/direct/Solver_ref.h>
#include <Quaternionic_linear_algebra/reduced/Reduced_form.h>
#include <Quaternionic_linear_algebra/reduced/Schur_reduced_solver.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <variant>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief Returns the pattern of B^T X B for quaternionic matrices X with the given pattern: four
/// real rows for every row, two for a reduced one. O(entries)
std::shared_ptr<const Sparse_pattern> reduced_pattern(const Sparse_pattern& pattern,
                                                      const internal::Reduced_rows& rows);

/// \ingroup PkgLinearAlgebra
/// \brief Assembles R = B^T X B, a real symmetric matrix with entries <u, X_ij v> for all basis
/// vectors u of row i and v of row j [CGP 5.7]. In place, O(entries).
/// \param R a matrix with `reduced_pattern(X.pattern(), B.rows())`; its values are replaced
template <class FT>
void assemble_reduced_matrix(const Hermitian_sparse_matrix<Quaternion<FT>>& X,
                             const internal::Reduced_basis<FT>& B, Hermitian_sparse_matrix<FT>& R)
{
  const internal::Reduced_rows& rows = B.rows();
  std::array<int, 4> next{};  // next entry in each column of row j
  X.for_each_entry([&, last = -1](int i, int j, const Quaternion<FT>& x) mutable {
    if (j != last)
      for (int c = 0; c < rows.dimension(j); ++c)
        next[static_cast<std::size_t>(c)] =
            R.pattern().offsets[static_cast<std::size_t>(rows.first(j) + c)];
    last = j;
    for (int c = 0; c < rows.dimension(j); ++c) {
      const Quaternion<FT> image = x * B.vector(j, c);
      for (int r = i == j ? c : 0; r < rows.dimension(i); ++r)
        R.value(next[static_cast<std::size_t>(c)]++) = dot(B.vector(i, r), image);
    }
  });
}

/// \ingroup PkgLinearAlgebra
/// \brief Repeats one number per row for each of its coordinates: the diagonal of B^T diag(m) B.
template <class FT>
Vector<FT> reduced_diagonal(const Vector<FT>& m, const internal::Reduced_rows& rows)
{
  Vector<FT> d(rows.dimension());
  for (int i = 0; i < rows.size(); ++i)
    d.segment(rows.first(i), rows.dimension(i)).setConstant(m[i]);
  return d;
}

/// \ingroup PkgLinearAlgebra
/// \brief Expands an ordering of the rows to their coordinates, which stay adjacent.
internal::Ordering reduced_ordering(const internal::Ordering& order,
                                    const internal::Reduced_rows& rows);

namespace internal {

/// \brief Solves with R = B^T (X + diag(shift)) B as a sparse real matrix, with a solver for real
/// matrices. Simple, and the best choice if most of the vertices lie on the boundary.
///
/// The n-vertex graph is ordered; its ordering is expanded such that the coordinates of each vertex
/// are adjacent. For all functions see `Reduced_hermitian_solver`.
class Real_reduced_solver {
 public:
  using FT = double;
  using Scalar = Quaternion<double>;

  explicit Real_reduced_solver(Solver_ref<double> solver = {}) : m_solver(std::move(solver)) {}

  Solver_status analyze(const Sparse_pattern& pattern, const Reduced_rows& rows,
                        const Ordering& order);
  Solver_status factorize(const Hermitian_sparse_matrix<Scalar>& X, const Vector<FT>& shift,
                          const Reduced_basis<FT>& basis);
  Solver_status solve(const Block<Scalar>& b, Block<Scalar>& x) const;
  void release();

  /// Cost of the real factor
  Solver_statistics statistics() const { return m_solver.statistics(); }

 private:
  Reduced_rows m_rows;
  Reduced_basis<FT> m_basis;
  int m_entries = 0;
  Hermitian_sparse_matrix<FT> m_matrix;
  Solver_ref<double> m_solver;
  bool m_is_factorized = false;
};

/// \brief Solves systems with the real symmetric matrix R = B^T (X + diag(shift)) B, where X is
/// quaternionic and Hermitian and some of the unknowns lie in planes of H: boundary vertices with
/// prescribed directions [CGP 5.7].
///
/// Right-hand sides and solutions are quaternionic vectors: b is restricted, x = B R^-1 B^T b lies
/// in the reduced space. b -> x is symmetric and linear over the real numbers only.
/// `Schur_reduced_solver` and `Real_reduced_solver` factor in different ways, with the same
/// interface; this class chooses the cheaper one, see `choose_reduced_form()`. As for the models of
/// SparseHermitianSolver, failures are reported as a status and never as an exception, and a call
/// that does not fit the earlier ones returns `Solver_status::wrong_state`.
class Reduced_hermitian_solver {
 public:
  using FT = double;
  using Scalar = Quaternion<FT>;

  Reduced_hermitian_solver() = default;
  Reduced_hermitian_solver(const Reduced_hermitian_solver&) = delete;
  Reduced_hermitian_solver& operator=(const Reduced_hermitian_solver&) = delete;

  /// \brief Prepares for matrices X with this pattern that are reduced at the given rows.
  Solver_status analyze(const Sparse_pattern& pattern, const Reduced_rows& rows);

  /// Likewise, with the position of vertex i in column i of `positions`, 3 x n, as a hint
  Solver_status analyze_with_positions(const Sparse_pattern& pattern, const Reduced_rows& rows,
                                       const Eigen::Matrix3Xd& positions);

  /// Likewise, with a given ordering of all rows
  Solver_status analyze(const Sparse_pattern& pattern, const Reduced_rows& rows,
                        const Ordering& order);

  /// Returns whether the whole matrix is factored as a real one
  bool has_real_form() const { return std::holds_alternative<Real_reduced_solver>(m_solver); }

  /// \brief Factorizes R.
  ///
  /// \param shift one number per row of X, or empty
  /// \param basis has the rows of the analysis
  /// \returns `Solver_status::not_positive_definite` if R is not positive definite
  Solver_status factorize(const Hermitian_sparse_matrix<Scalar>& X, const Vector<FT>& shift,
                          const Reduced_basis<FT>& basis);

  /// \brief Computes x = B R^-1 B^T b, for all columns of b.
  ///
  /// \param x is resized; unchanged unless the status is `Solver_status::success`
  Solver_status solve(const Block<Scalar>& b, Block<Scalar>& x) const;

  /// Releases the memory of the factor; the analysis stays, and `factorize()` must come next
  void release();

  /// Cost of the factorization, entries counted as real numbers; zeros before `analyze()`
  Solver_statistics statistics() const;

 private:
  Solver_status forget();
  Solver_status adopt(const Sparse_pattern& pattern, const Reduced_rows& rows,
                      const Eigen::Matrix3Xd* positions);
  Solver_status adopt(const Sparse_pattern& pattern, const Reduced_rows& rows,
                      const Reduced_form& form);

  std::variant<Schur_reduced_solver, Real_reduced_solver> m_solver;
};

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief The operator x -> B B^T A x for all columns of x at once: the matrix B^T A B as an
/// operator on quaternionic vectors, with values in the reduced space. Stores references.
///
/// With `inverse_operator()` of a reduced solver an eigensolver can iterate on such vectors,
/// provided that it combines them with *real* coefficients: its inner products are those of
/// `real_gram_matrix()`.
template <class FT>
auto reduced_operator(const Hermitian_sparse_matrix<Quaternion<FT>>& A,
                      const internal::Reduced_basis<FT>& basis)
{
  return [apply = block_operator(A), &basis](const Block<Quaternion<FT>>& x) {
    return basis.project(apply(x));
  };
}

}  // namespace Conformal_geometry_processing
