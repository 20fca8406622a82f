// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/adapters/Embedded_hermitian_solver.h>
#include <Quaternionic_linear_algebra/direct/Ordering.h>
#include <Quaternionic_linear_algebra/direct/Supernodal_cholesky.h>

#include <memory>
#include <numeric>
#include <utility>

namespace cgp_test {

namespace CGP = Conformal_geometry_processing;

/// the library's own factorization of numbers, as a backend of `Embedded_hermitian_solver`
template <class Entry>
class Supernodal_backend {
 public:
  using Matrix = Eigen::SparseMatrix<Entry, Eigen::ColMajor, int>;

  /// approximate minimum degree
  static CGP::Solver_status find_ordering(const CGP::Sparse_pattern& pattern,
                                          CGP::internal::Ordering& order)
  {
    order = CGP::amd_ordering(pattern);
    return CGP::Solver_status::success;
  }

  CGP::Solver_status analyze(const Matrix& A)
  {
    auto pattern = std::make_shared<CGP::Sparse_pattern>();
    pattern->offsets.assign(A.outerIndexPtr(), A.outerIndexPtr() + A.cols() + 1);
    pattern->indices.assign(A.innerIndexPtr(), A.innerIndexPtr() + A.nonZeros());
    CGP::internal::Ordering natural(static_cast<std::size_t>(A.cols()));
    std::iota(natural.begin(), natural.end(), 0);
    m_matrix = CGP::Hermitian_sparse_matrix<Entry>(std::move(pattern));
    return m_solver.analyze(m_matrix.pattern(), natural);
  }

  CGP::Solver_status factorize(const Matrix& A)
  {
    for (int k = 0; k < m_matrix.pattern().size_of_entries(); ++k)
      m_matrix.value(k) = A.valuePtr()[k];
    return m_solver.factorize(m_matrix, {});
  }

  CGP::Solver_status solve(const CGP::Block<Entry>& b, CGP::Block<Entry>& x) const
  {
    return m_solver.solve(b, x);
  }

  CGP::Solver_statistics statistics() const { return m_solver.statistics(); }

 private:
  CGP::Hermitian_sparse_matrix<Entry> m_matrix;
  CGP::Supernodal_cholesky<Entry> m_solver;
};

/// \brief solvers with quaternionic matrices in their real 4n x 4n form, two to seven times slower
/// than those of the library: cross-checks that share a backend, but not the quaternionic algebra.
template <template <class> class Backend>
struct Real_form_traits {
  template <class Scalar>
  using Solver = CGP::Embedded_hermitian_solver<Scalar, Backend, CGP::internal::Real_embedding>;
};

}  // namespace cgp_test
