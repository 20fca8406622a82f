// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/linear_algebra/adapters/Solver_embedding.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing::internal {

int embedded_entries(std::int64_t n, std::int64_t blocks, std::int64_t width);

/// \ingroup PkgLinearAlgebra
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

}  // namespace Conformal_geometry_processing::internal
