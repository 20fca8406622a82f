// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/linear_algebra/adapters/Embedded_matrix.h>
#include <Conformal_geometry_processing/linear_algebra/dense/Solver_status.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Ordering.h>

#include <cstdint>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief Adapts a sparse solver of another library to real and quaternionic matrices.
///
/// The matrix is passed in elimination order, as a matrix of numbers: n x n for real scalars,
/// complex 2n x 2n or real 4n x 4n for quaternions. The other library therefore never orders the
/// larger graph. Entries that are not finite are detected here, because libraries handle them
/// differently.
///
/// \cgalModels{SparseHermitianSolver}
/// \tparam Scalar_ `double` or `Quaternion<double>`
/// \tparam Backend a class template over the entries, see `Eigen_backend`
/// \tparam Embedding_ the type of the entries: `Complex_embedding` or `Real_embedding`
template <class Scalar_, template <class> class Backend,
          template <class> class Embedding_ = internal::Complex_embedding>
class Embedded_hermitian_solver {
 public:
  using Scalar = Scalar_;
  using FT = typename internal::Scalar_traits<Scalar>::FT;

  Embedded_hermitian_solver() = default;
  Embedded_hermitian_solver(const Embedded_hermitian_solver&) = delete;
  Embedded_hermitian_solver& operator=(const Embedded_hermitian_solver&) = delete;

  Solver_status analyze(const Sparse_pattern& pattern)
  {
    return internal::guarded([&] {
      m_state = State::empty;
      if (pattern.size() == 0) return Solver_status::wrong_state;
      internal::Ordering order;
      const Solver_status status = Backend<Entry>::find_ordering(pattern, order);
      return status == Solver_status::success ? analyze(pattern, order) : status;
    });
  }

  Solver_status analyze(const Sparse_pattern& pattern, const internal::Ordering& order)
  {
    return internal::guarded([&] {
      m_state = State::empty;
      m_new_of_old = inverse_permutation(order);
      if (pattern.size() == 0 || size() != pattern.size()) return Solver_status::wrong_state;
      m_ordering = order;
      m_entries = pattern.size_of_entries();
      m_matrix = Matrix(pattern, m_new_of_old);
      const Solver_status status = m_backend.analyze(m_matrix.matrix());
      if (status == Solver_status::success) m_state = State::analyzed;
      return status;
    });
  }

  /// Ignores the positions
  Solver_status analyze_with_positions(const Sparse_pattern& pattern, const Eigen::Matrix3Xd&)
  {
    return analyze(pattern);
  }

  /// Uses the ordering of another solver for the same pattern
  template <class Other>
  Solver_status analyze_like(const Sparse_pattern& pattern, const Other& other)
  {
    return analyze(pattern, other.ordering());
  }

  const internal::Ordering& ordering() const { return m_ordering; }

  Solver_status factorize(const Hermitian_sparse_matrix<Scalar>& A, const Vector<FT>& shift)
  {
    return internal::guarded([&] {
      if (!fits(A, shift)) return Solver_status::wrong_state;
      m_state = State::analyzed;
      m_matrix.set_values(A, shift);
      if (!m_matrix.matrix().coeffs().allFinite()) return Solver_status::numerical_issue;
      const Solver_status status = m_backend.factorize(m_matrix.matrix());
      if (status == Solver_status::success) m_state = State::factorized;
      return status;
    });
  }

  Solver_status solve(const Block<Scalar>& b, Block<Scalar>& x) const
  {
    return internal::guarded([&] {
      if (m_state != State::factorized || b.rows() != size()) return Solver_status::wrong_state;
      Block<Entry> solution(width * b.rows(), 0);
      // CHOLMOD 3.0.14 takes the null pointer of a matrix without columns for an invalid type.
      const Solver_status status =
          b.cols() == 0 ? Solver_status::success : m_backend.solve(to_entries(b), solution);
      if (status == Solver_status::success) x = from_entries(solution);
      return status;
    });
  }

  Solver_statistics statistics() const
  {
    Solver_statistics s = m_state == State::empty ? Solver_statistics{} : m_backend.statistics();
    // Diagonal blocks are stored as lower triangles.
    const std::int64_t w = width, diagonal = s.factor_entries > 0 ? size() : 0;
    s.factor_entries = (s.factor_entries - diagonal * w * (w + 1) / 2) / (w * w) + diagonal;
    return s;
  }

 private:
  using Embedding = Embedding_<Scalar>;
  using Entry = typename Embedding::Entry;
  using Matrix = internal::Embedded_matrix<Scalar, Embedding>;
  static constexpr int width = Embedding::width;
  enum class State { empty, analyzed, factorized };

  int size() const { return static_cast<int>(m_new_of_old.size()); }

  bool fits(const Hermitian_sparse_matrix<Scalar>& A, const Vector<FT>& shift) const
  {
    return m_state != State::empty && A.size() == size() &&
           A.pattern().size_of_entries() == m_entries &&
           (shift.size() == 0 || shift.size() == A.size());
  }

  // The row of the original matrix that is block k in elimination order.
  int row(Eigen::Index k) const { return m_ordering[static_cast<std::size_t>(k)]; }

  Block<Entry> to_entries(const Block<Scalar>& b) const
  {
    Block<Entry> e(width * b.rows(), b.cols());
    for (Eigen::Index c = 0; c < b.cols(); ++c)
      for (Eigen::Index k = 0; k < b.rows(); ++k)
        Embedding::to_entries(b(row(k), c), &e(width * k, c));
    return e;
  }

  Block<Scalar> from_entries(const Block<Entry>& e) const
  {
    Block<Scalar> x(size(), e.cols());
    for (Eigen::Index c = 0; c < x.cols(); ++c)
      for (Eigen::Index k = 0; k < x.rows(); ++k)
        x(row(k), c) = Embedding::from_entries(&e(width * k, c));
    return x;
  }

  State m_state = State::empty;
  int m_entries = 0;
  internal::Ordering m_ordering;
  std::vector<int> m_new_of_old;
  Matrix m_matrix;
  Backend<Entry> m_backend;
};

}  // namespace Conformal_geometry_processing
