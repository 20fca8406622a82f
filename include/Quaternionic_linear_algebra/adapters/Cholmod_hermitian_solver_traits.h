// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/adapters/Embedded_hermitian_solver.h>

#include <Eigen/CholmodSupport>

#include <cholmod.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// Translates `cholmod_common::status`.
inline Solver_status cholmod_status(int status)
{
  switch (status) {
    case CHOLMOD_OK:
      return Solver_status::success;
    case CHOLMOD_NOT_POSDEF:
    case CHOLMOD_DSMALL:
      return Solver_status::not_positive_definite;
    case CHOLMOD_OUT_OF_MEMORY:
    case CHOLMOD_TOO_LARGE:
      return Solver_status::out_of_memory;
    default:
      return Solver_status::numerical_issue;
  }
}

namespace internal {

/// \brief Supernodal LL^H factorization by CHOLMOD, as a backend of `Embedded_hermitian_solver`.
///
/// This is the only header that includes CHOLMOD, whose supernodal module is under the GPL. The
/// speed depends on the BLAS: the reference BLAS is 2 to 5 times slower than OpenBLAS.
template <class Entry>
class Cholmod_backend {
 public:
  using Matrix = Eigen::SparseMatrix<Entry, Eigen::ColMajor, int>;

  /// Uses CHOLMOD's default strategy: minimum degree, or METIS if minimum degree causes too much
  /// fill
  static Solver_status find_ordering(const Sparse_pattern& pattern, Ordering& order)
  {
    Common common;
    cholmod_sparse graph{};
    graph.nrow = graph.ncol = static_cast<std::size_t>(pattern.size());
    graph.nzmax = pattern.indices.size();
    graph.p = const_cast<int*>(pattern.offsets.data());
    graph.i = const_cast<int*>(pattern.indices.data());
    graph.stype = -1;
    graph.itype = CHOLMOD_INT;
    graph.xtype = CHOLMOD_PATTERN;
    graph.dtype = CHOLMOD_DOUBLE;
    graph.sorted = graph.packed = 1;
    cholmod_factor* factor = cholmod_analyze(&graph, &common.settings);
    if (factor == nullptr) return failure(common.settings);
    const int* const first = static_cast<int*>(factor->Perm);
    order.assign(first, first + pattern.size());
    cholmod_free_factor(&factor, &common.settings);
    return Solver_status::success;
  }

  Solver_status analyze(const Matrix& A)
  {
    m_llt.analyzePattern(A);
    return m_llt.has_factor() ? Solver_status::success : failure(m_llt.cholmod());
  }

  Solver_status factorize(const Matrix& A)
  {
    m_llt.factorize(A);
    return m_llt.info() == Eigen::Success ? cholmod_status(m_llt.cholmod().status)
                                          : failure(m_llt.cholmod());
  }

  Solver_status solve(const Block<Entry>& b, Block<Entry>& x) const
  {
    x = m_llt.solve(b);
    if (m_llt.info() != Eigen::Success) return failure(m_llt.settings());
    return x.allFinite() ? Solver_status::success : Solver_status::numerical_issue;
  }

  Solver_statistics statistics() const { return m_llt.statistics(); }

 private:
  // Returns the status of a failed call, even if CHOLMOD did not set one.
  static Solver_status failure(const cholmod_common& common)
  {
    const Solver_status status = cholmod_status(common.status);
    return status == Solver_status::success ? Solver_status::numerical_issue : status;
  }

  // Configured for the ordering only: simplicial, without messages.
  struct Common {
    Common()
    {
      cholmod_start(&settings);
      settings.print = 0;
      settings.supernodal = CHOLMOD_SIMPLICIAL;
    }
    Common(const Common&) = delete;
    Common& operator=(const Common&) = delete;
    ~Common() { cholmod_finish(&settings); }

    cholmod_common settings;
  };

  // Always supernodal. Keeps the given order up to a postordering, which does not change the fill.
  class Llt : public Eigen::CholmodBase<Matrix, Eigen::Lower, Llt> {
   public:
    Llt()
    {
      this->m_cholmod.print = 0;
      this->m_cholmod.supernodal = CHOLMOD_SUPERNODAL;
      this->m_cholmod.final_asis = 1;
      this->m_cholmod.nmethods = 1;
      this->m_cholmod.method[0].ordering = CHOLMOD_NATURAL;
      this->m_cholmod.postorder = 1;
    }

    bool has_factor() const { return this->m_cholmodFactor != nullptr; }
    const cholmod_common& settings() const { return this->m_cholmod; }

    Solver_statistics statistics() const
    {
      const double operations_per_entry = Eigen::NumTraits<Entry>::IsComplex ? 4 : 1;
      const cholmod_factor& factor = *this->m_cholmodFactor;
      Solver_statistics s;
      s.factor_entries = static_cast<std::int64_t>(this->m_cholmod.lnz);
      s.flops = operations_per_entry * this->m_cholmod.fl;
      s.bytes = static_cast<double>(factor.xsize) * sizeof(Entry) +
                static_cast<double>(factor.ssize) * sizeof(int);
      return s;
    }
  };

  Llt m_llt;
};

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Solvers of SuiteSparse; link the component `cholmod`.
/// \cgalModels{SparseHermitianSolverTraits}
struct Cholmod_hermitian_solver_traits {
  template <class Scalar>
  using Solver = Embedded_hermitian_solver<Scalar, internal::Cholmod_backend>;
};

}  // namespace Conformal_geometry_processing
