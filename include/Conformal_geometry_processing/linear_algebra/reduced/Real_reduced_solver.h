// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/algebra/Reduced_basis.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Solver_ref.h>

#include <utility>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgLinearAlgebra
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

}  // namespace Conformal_geometry_processing::internal
