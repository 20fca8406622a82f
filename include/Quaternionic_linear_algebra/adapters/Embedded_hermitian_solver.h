// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>
#include <Quaternionic_linear_algebra/dense/Solver_status.h>
#include <Quaternionic_linear_algebra/direct/Ordering.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <new>
#include <numeric>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

/// \brief Represents a scalar as a `width` x `width` matrix of entries that other libraries
/// support, which acts on vectors of `width` coordinates; numbers represent themselves.
template <class Scalar>
struct Number_embedding {
  using Entry = Scalar;
  static constexpr int width = 1;
  using Matrix = Eigen::Matrix<Entry, width, width>;

  /// Matrix of the left multiplication by s
  static Matrix block(const Scalar& s) { return Matrix::Constant(s); }
  /// Writes the `width` coordinates of s
  static void to_entries(const Scalar& s, Entry* entries) { *entries = s; }
  /// Converts coordinates to a scalar
  static Scalar from_entries(const Entry* entries) { return *entries; }
};

/// \brief A `Number_embedding` with quaternions as complex 2 x 2 matrices; takes half the memory
/// and time of real 4 x 4 matrices.
template <class Scalar>
struct Complex_embedding : Number_embedding<Scalar> {};

template <class FT>
struct Complex_embedding<Quaternion<FT>> {
  using Entry = std::complex<FT>;
  static constexpr int width = 2;
  using Matrix = Eigen::Matrix<Entry, width, width>;

  static Matrix block(const Quaternion<FT>& q) { return complex_block(q); }
  static void to_entries(const Quaternion<FT>& q, Entry* entries)
  {
    Eigen::Map<Eigen::Matrix<Entry, width, 1>>{entries} = complex_coordinates(q);
  }
  static Quaternion<FT> from_entries(const Entry* entries)
  {
    return quaternion(entries[0], entries[1]);
  }
};

/// \brief A `Number_embedding` with quaternions as real 4 x 4 matrices, for libraries that support
/// real numbers only.
template <class Scalar>
struct Real_embedding : Number_embedding<Scalar> {};

template <class FT>
struct Real_embedding<Quaternion<FT>> {
  using Entry = FT;
  static constexpr int width = 4;
  using Matrix = Eigen::Matrix<Entry, width, width>;

  static Matrix block(const Quaternion<FT>& q) { return real_block(q); }
  static void to_entries(const Quaternion<FT>& q, Entry* entries)
  {
    entries[0] = q.w;
    entries[1] = q.x;
    entries[2] = q.y;
    entries[3] = q.z;
  }
  static Quaternion<FT> from_entries(const Entry* entries)
  {
    return {entries[0], entries[1], entries[2], entries[3]};
  }
};

// Number of entries in the lower triangle: n diagonal blocks, stored as triangles, and full blocks.
inline int embedded_entries(std::int64_t n, std::int64_t blocks, std::int64_t width)
{
  const std::int64_t entries = width * (width + 1) / 2 * n + width * width * blocks;
  if (entries > (std::numeric_limits<int>::max)()) throw std::bad_alloc();
  return static_cast<int>(entries);
}

/// \brief A Hermitian sparse matrix as an `Eigen::SparseMatrix` of numbers, in elimination order.
///
/// Row k of the result is row `order[k]` of the given matrix; only the lower triangle is stored.
/// The pattern is built once; `set_values()` overwrites the values in place and in memory order,
/// without searches, insertions or allocations. O(|V| + |E|) each.
/// \tparam Embedding_ of the scalars, such as `Complex_embedding`
template <class Scalar, class Embedding_>
class Embedded_matrix {
 public:
  using Embedding = Embedding_;
  using Entry = typename Embedding::Entry;
  using FT = typename Scalar_traits<Scalar>::FT;
  using Matrix = Eigen::SparseMatrix<Entry, Eigen::ColMajor, int>;
  static constexpr int width = Embedding::width;

  Embedded_matrix() = default;

  /// \param new_of_old the position of every row in the elimination order, a permutation
  /// \throws std::bad_alloc if the number of entries exceeds the range of `int`
  Embedded_matrix(const Sparse_pattern& pattern, const std::vector<int>& new_of_old)
  {
    find_blocks(pattern, new_of_old);
    build_pattern();
  }

  const Matrix& matrix() const { return m_matrix; }

  /// Sets the values of A + diag(shift); `shift` may be empty
  void set_values(const Hermitian_sparse_matrix<Scalar>& A, const Vector<FT>& shift)
  {
    Entry* const values = m_matrix.valuePtr();
    const int* const starts = m_matrix.outerIndexPtr();
    for (int j = 0; j < size(); ++j) {
      std::array<Entry*, width> next;
      for (int c = 0; c < width; ++c) next[at(c)] = values + starts[width * j + c];
      write_diagonal(diagonal(A, shift, j), next);
      for (int k = m_offsets[at(j)]; k < m_offsets[at(j) + 1]; ++k)
        write_block(block(A, m_blocks[at(k)].source), next);
    }
  }

 private:
  // A block below the diagonal; source is the position of its value in the pattern, or ~position
  // if the permutation requires its conjugate transpose.
  struct Below {
    int row, source;
  };

  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  int size() const { return static_cast<int>(m_diagonals.size()); }

  void find_blocks(const Sparse_pattern& pattern, const std::vector<int>& new_of_old)
  {
    const int n = pattern.size();
    m_diagonals.resize(at(n));
    m_offsets.assign(at(n) + 1, 0);
    const auto visit = [&](auto action) {
      for (int j = 0; j < n; ++j)
        for (int k = pattern.offsets[at(j)] + 1; k < pattern.offsets[at(j) + 1]; ++k)
          action(new_of_old[at(pattern.indices[at(k)])], new_of_old[at(j)], k);
    };
    visit([&](int i, int j, int) { ++m_offsets[at((std::min)(i, j)) + 1]; });
    std::partial_sum(m_offsets.begin(), m_offsets.end(), m_offsets.begin());
    m_blocks.resize(at(m_offsets.back()));
    std::vector<int> next(m_offsets.begin(), m_offsets.end() - 1);
    visit([&](int i, int j, int k) {
      m_blocks[at(next[at((std::min)(i, j))]++)] = {(std::max)(i, j), i > j ? k : ~k};
    });
    for (int j = 0; j < n; ++j) {
      m_diagonals[at(new_of_old[at(j)])] = {j, pattern.offsets[at(j)]};
      std::sort(m_blocks.begin() + m_offsets[at(j)], m_blocks.begin() + m_offsets[at(j) + 1],
                [](const Below& a, const Below& b) { return a.row < b.row; });
    }
  }

  void build_pattern()
  {
    const int blocks = static_cast<int>(m_blocks.size());
    const int entries = internal::embedded_entries(size(), blocks, width);
    m_matrix.resize(width * size(), width * size());
    m_matrix.resizeNonZeros(entries);
    int position = 0;
    for (int j = 0; j < size(); ++j)
      for (int c = 0; c < width; ++c) {
        m_matrix.outerIndexPtr()[width * j + c] = position;
        for (int r = c; r < width; ++r) m_matrix.innerIndexPtr()[position++] = width * j + r;
        for (int k = m_offsets[at(j)]; k < m_offsets[at(j) + 1]; ++k)
          for (int r = 0; r < width; ++r)
            m_matrix.innerIndexPtr()[position++] = width * m_blocks[at(k)].row + r;
      }
    m_matrix.outerIndexPtr()[width * size()] = position;
  }

  FT diagonal(const Hermitian_sparse_matrix<Scalar>& A, const Vector<FT>& shift, int j) const
  {
    const auto [old, source] = m_diagonals[at(j)];
    return Scalar_traits<Scalar>::real(A.value(source)) + (shift.size() > 0 ? shift[old] : FT(0));
  }

  static typename Embedding::Matrix block(const Hermitian_sparse_matrix<Scalar>& A, int source)
  {
    return Embedding::block(source >= 0 ? A.value(source) : conjugate(A.value(~source)));
  }

  // The lower triangle of a real multiple of the identity.
  static void write_diagonal(FT value, std::array<Entry*, width>& next)
  {
    for (int c = 0; c < width; ++c)
      for (int r = c; r < width; ++r) *next[at(c)]++ = r == c ? Entry(value) : Entry(0);
  }

  static void write_block(const typename Embedding::Matrix& block, std::array<Entry*, width>& next)
  {
    for (int c = 0; c < width; ++c)
      for (int r = 0; r < width; ++r) *next[at(c)]++ = block(r, c);
  }

  std::vector<std::pair<int, int>> m_diagonals;  // old number and position in the given pattern
  std::vector<int> m_offsets;                    // first block of each column
  std::vector<Below> m_blocks;
  Matrix m_matrix;
};

}  // namespace internal

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
