// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Quaternion.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {

struct Sparse_pattern;

namespace internal {

/// The entries of the strictly lower triangle of a pattern, row by row
struct Lower_rows {
  struct Entry {
    int column, position;
  };
  std::vector<int> offsets;    ///< number of rows + 1 positions in `entries`
  std::vector<Entry> entries;  ///< in each row by ascending columns
};

/// \brief The rows of a pattern, from the first time that they are asked for.
///
/// A copy of the pattern, which may be changed, has to find its own.
class Kept_rows {
 public:
  Kept_rows() = default;
  Kept_rows(const Kept_rows&) noexcept {}
  Kept_rows& operator=(const Kept_rows&) noexcept
  {
    m_rows.reset();
    return *this;
  }

  /// May be called from several threads
  /// \param pattern always the same
  const Lower_rows& of(const Sparse_pattern& pattern) const;

 private:
  mutable std::mutex m_mutex;
  mutable std::unique_ptr<const Lower_rows> m_rows;
};

}  // namespace internal

/// \ingroup PkgAlgebra
/// \brief The pattern of a Hermitian sparse matrix: its lower triangle, column by column.
///
/// Column j holds the rows `indices[offsets[j]] ... indices[offsets[j+1] - 1]`, ascending; the
/// first one is always the diagonal, j. For a mesh, column j contains vertex j and its neighbours
/// of larger number, so the pattern has |V| + |E| entries. The real, complex and quaternionic
/// matrices of a mesh share one pattern, which never changes.
struct Sparse_pattern {
  std::vector<int> offsets;            ///< size() + 1 positions in `indices`
  std::vector<int> indices;            ///< row numbers
  internal::Kept_rows kept_rows = {};  ///< of the finished pattern, see `rows()`

  /// Number of rows, which equals the number of columns
  int size() const { return offsets.empty() ? 0 : static_cast<int>(offsets.size()) - 1; }

  /// Number of stored entries of the lower triangle
  int size_of_entries() const { return static_cast<int>(indices.size()); }

  /// Position of entry (i, j) among the stored ones, -1 if it is not stored; O(log degree)
  /// \pre i >= j
  int find(int i, int j) const;

  /// \brief Its strictly lower triangle row by row, which is found at the first call; O(size of
  /// entries) then. May be called from several threads.
  /// \pre nothing changes the pattern any more
  const internal::Lower_rows& rows() const { return kept_rows.of(*this); }

  friend bool operator==(const Sparse_pattern& a, const Sparse_pattern& b)
  {
    return a.offsets == b.offsets && a.indices == b.indices;
  }
};

/// \ingroup PkgAlgebra
/// \brief The pattern that has, besides its diagonal, the rows `columns[j]` in each column j.
/// \param columns in any order, a row as often as it comes
/// \pre no row of column j is less than j
std::shared_ptr<const Sparse_pattern> sparse_pattern(std::vector<std::vector<int>> columns);

/// \ingroup PkgAlgebra
/// \brief A Hermitian sparse matrix, A_ji = conjugate(A_ij), with values on a fixed pattern.
///
/// Only the lower triangle is stored; assembly writes directly to `value(k)` at a known position k.
/// Acts on vectors from the left, and is therefore right-linear over the scalars:
/// A (x q) = (A x) q.
///
/// \tparam Scalar_ a floating-point type, or `std::complex` or `Quaternion` of one
template <class Scalar_>
class Hermitian_sparse_matrix {
 public:
  using Scalar = Scalar_;
  using FT = typename internal::Scalar_traits<Scalar>::FT;

  /// The empty matrix
  Hermitian_sparse_matrix() : m_pattern(std::make_shared<Sparse_pattern>()) {}

  /// The zero matrix on a pattern, which is shared, not copied
  explicit Hermitian_sparse_matrix(std::shared_ptr<const Sparse_pattern> pattern)
      : m_pattern(std::move(pattern)), m_values(m_pattern->size_of_entries())
  {
    set_zero();
  }

  int size() const { return m_pattern->size(); }
  const Sparse_pattern& pattern() const { return *m_pattern; }
  const std::shared_ptr<const Sparse_pattern>& shared_pattern() const { return m_pattern; }

  /// The value at position k of the pattern
  Scalar& value(int k) { return m_values[k]; }
  const Scalar& value(int k) const { return m_values[k]; }

  void set_zero() { set_zero(0, size()); }

  /// Sets the columns first <= j < last of the lower triangle to zero
  void set_zero(int first, int last)
  {
    const int* const offsets = m_pattern->offsets.data();
    if (first < last)
      m_values.segment(offsets[first], offsets[last] - offsets[first]).setConstant(Scalar{});
  }

  /// The (real) diagonal entry of column j
  FT diagonal(int j) const
  {
    return internal::Scalar_traits<Scalar>::real(
        m_values[m_pattern->offsets[static_cast<std::size_t>(j)]]);
  }

  /// Entry (i, j) of the full matrix, zero outside the pattern; O(log degree)
  Scalar coefficient(int i, int j) const
  {
    const int k = i >= j ? m_pattern->find(i, j) : m_pattern->find(j, i);
    if (k < 0) return Scalar{};
    return i >= j ? m_values[k] : conjugate(m_values[k]);
  }

  /// Returns y = A x
  template <class X>
  Vector<Scalar> operator*(const Eigen::MatrixBase<X>& x) const
  {
    Vector<Scalar> y(size());
    multiply(x.derived(), y);
    return y;
  }

  /// Computes y = A x, in the memory of y
  /// \tparam X, Y vectors or columns with as many entries as A has rows
  template <class X, class Y>
  void multiply(const X& x, Y&& y) const
  {
    multiply_rows(0, size(), x, y);
  }

  /// Computes the entries first <= i < last of y = A x
  template <class X, class Y>
  void multiply_rows(int first, int last, const X& x, Y&& y) const
  {
    const internal::Lower_rows& rows = m_pattern->rows();
    const int* const indices = m_pattern->indices.data();
    const int* const columns = m_pattern->offsets.data();
    for (int i = first; i < last; ++i) {
      internal::Inner_product<Scalar> sum;
      const auto* const end = rows.entries.data() + rows.offsets.data()[i + 1];
      for (const auto* e = rows.entries.data() + rows.offsets.data()[i]; e != end; ++e)
        sum.add_product(m_values[e->position], x[e->column]);
      // The rest of row i is conjugate to column i.
      for (int k = columns[i]; k < columns[i + 1]; ++k) sum.add(m_values[k], x[indices[k]]);
      y[i] = sum.sum();
    }
  }

  /// Calls visit(i, j, A_ij) for every stored entry, i >= j, in the order of the pattern
  template <class Visitor>
  void for_each_entry(Visitor visit) const
  {
    const int* const rows = m_pattern->indices.data();
    const int* const offsets = m_pattern->offsets.data();
    for (int j = 0; j < size(); ++j)
      for (int k = offsets[j]; k < offsets[j + 1]; ++k) visit(rows[k], j, m_values[k]);
  }

 private:
  std::shared_ptr<const Sparse_pattern> m_pattern;
  Vector<Scalar> m_values;
};

}  // namespace Conformal_geometry_processing
