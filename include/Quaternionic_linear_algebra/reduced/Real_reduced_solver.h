// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>
#include <Quaternionic_linear_algebra/algebra/Reduced_basis.h>
#include <Quaternionic_linear_algebra/direct/Ordering.h>
#include <Quaternionic_linear_algebra/direct/Solver_ref.h>

#include <array>
#include <cstddef>
#include <memory>
#include <utility>

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

}  // namespace internal
}  // namespace Conformal_geometry_processing
