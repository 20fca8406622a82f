// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/adapters/Embedded_hermitian_solver.h>
#include <Quaternionic_linear_algebra/direct/Ordering.h>
#include <Quaternionic_linear_algebra/direct/Supernodal_cholesky.h>

#include <memory>
#include <numeric>
#include <utility>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgLinearAlgebra
/// \brief The library's own factorization of numbers, as a backend of `Embedded_hermitian_solver`.
template <class Entry>
class Supernodal_backend {
 public:
  using Matrix = Eigen::SparseMatrix<Entry, Eigen::ColMajor, int>;

  /// approximate minimum degree
  static Solver_status find_ordering(const Sparse_pattern& pattern, Ordering& order)
  {
    order = amd_ordering(pattern);
    return Solver_status::success;
  }

  Solver_status analyze(const Matrix& A)
  {
    auto pattern = std::make_shared<Sparse_pattern>();
    pattern->offsets.assign(A.outerIndexPtr(), A.outerIndexPtr() + A.cols() + 1);
    pattern->indices.assign(A.innerIndexPtr(), A.innerIndexPtr() + A.nonZeros());
    Ordering natural(static_cast<std::size_t>(A.cols()));
    std::iota(natural.begin(), natural.end(), 0);
    m_matrix = Hermitian_sparse_matrix<Entry>(std::move(pattern));
    return m_solver.analyze(m_matrix.pattern(), natural);
  }

  Solver_status factorize(const Matrix& A)
  {
    for (int k = 0; k < m_matrix.pattern().size_of_entries(); ++k)
      m_matrix.value(k) = A.valuePtr()[k];
    return m_solver.factorize(m_matrix, {});
  }

  Solver_status solve(const Block<Entry>& b, Block<Entry>& x) const { return m_solver.solve(b, x); }

  Solver_statistics statistics() const { return m_solver.statistics(); }

 private:
  Hermitian_sparse_matrix<Entry> m_matrix;
  Supernodal_cholesky<Entry> m_solver;
};

/// \ingroup PkgLinearAlgebra
/// \brief The library's own solvers with quaternionic matrices in their real 4n x 4n form; six to
/// seven times slower than `Supernodal_solver_traits`. Useful as a cross-check that shares the
/// kernels but not the quaternionic algebra.
///
/// Matrices that are real-linear but not quaternionic, such as those with two-dimensional unknowns
/// at the boundary, are factored by `Supernodal_cholesky<double>` itself, see
/// `expanded_pattern()`.
/// \cgalModels{SparseHermitianSolverTraits}
struct Supernodal_real_solver_traits {
  template <class Scalar>
  using Solver = Embedded_hermitian_solver<Scalar, Supernodal_backend, Real_embedding>;
};

}  // namespace Conformal_geometry_processing::internal
