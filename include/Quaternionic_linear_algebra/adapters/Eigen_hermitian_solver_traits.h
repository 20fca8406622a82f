// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/adapters/Embedded_hermitian_solver.h>
#include <Quaternionic_linear_algebra/direct/Ordering.h>

#include <Eigen/SparseCholesky>

#include <cmath>
#include <complex>

namespace Conformal_geometry_processing {
namespace internal {

/// \brief Simplicial LDL^H factorization by Eigen, as a backend of `Embedded_hermitian_solver`.
template <class Entry>
class Eigen_backend {
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
    m_ldlt.analyzePattern(A);
    return Solver_status::success;
  }

  /// Checks the pivots, since Eigen accepts negative pivots and pivots that are not finite.
  Solver_status factorize(const Matrix& A)
  {
    m_ldlt.factorize(A);
    if (m_ldlt.info() != Eigen::Success) return Solver_status::not_positive_definite;
    for (const Entry& pivot : m_ldlt.pivots()) {
      if (!std::isfinite(std::abs(pivot))) return Solver_status::numerical_issue;
      if (!(std::real(pivot) > 0)) return Solver_status::not_positive_definite;
    }
    return Solver_status::success;
  }

  Solver_status solve(const Block<Entry>& b, Block<Entry>& x) const
  {
    x = m_ldlt.solve(b);
    return x.allFinite() ? Solver_status::success : Solver_status::numerical_issue;
  }

  Solver_statistics statistics() const { return m_ldlt.statistics(); }

 private:
  // Exposes protected members of Eigen's factorization.
  class Ldlt : public Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Eigen::NaturalOrdering<int>> {
   public:
    const Eigen::Matrix<Entry, Eigen::Dynamic, 1>& pivots() const { return this->m_diag; }

    Solver_statistics statistics() const
    {
      const double operations_per_entry = Eigen::NumTraits<Entry>::IsComplex ? 4 : 1;
      Solver_statistics s;
      const int* const begin = this->m_matrix.outerIndexPtr();  // L without its unit diagonal
      for (Eigen::Index j = 0; j < this->m_matrix.cols(); ++j) {
        const int below = begin[j + 1] - begin[j];
        s.factor_entries += below + 1;
        s.flops += operations_per_entry * (below + 1.0) * (below + 1.0);
      }
      s.bytes = static_cast<double>(s.factor_entries) * (sizeof(Entry) + sizeof(int));
      return s;
    }
  };

  Ldlt m_ldlt;
};

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Solvers that depend on Eigen only; for small meshes.
/// \cgalModels{SparseHermitianSolverTraits}
struct Eigen_hermitian_solver_traits {
  template <class Scalar>
  using Solver = Embedded_hermitian_solver<Scalar, internal::Eigen_backend>;
};

}  // namespace Conformal_geometry_processing
