// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_ALGEBRA_SPARSE_PATTERN_H
#define CONFORMAL_GEOMETRY_PROCESSING_ALGEBRA_SPARSE_PATTERN_H

#include <algorithm>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgAlgebra
/// \brief where a Hermitian sparse matrix may be nonzero: its lower triangle, column by column.
///
/// Column j holds the rows `indices[offsets[j]] ... indices[offsets[j+1] - 1]`, ascending; the
/// first of them is j itself (the diagonal is always there). On a mesh column j is the vertex j
/// with its neighbours of larger number, so the pattern has |V| + |E| entries. One pattern serves
/// the real, complex and quaternionic matrices of a mesh, and never changes.
struct Sparse_pattern {
  std::vector<int> offsets;  ///< size() + 1 positions in `indices`
  std::vector<int> indices;  ///< row numbers

  /// number of rows, which is the number of columns
  int size() const { return offsets.empty() ? 0 : static_cast<int>(offsets.size()) - 1; }

  /// number of stored entries of the lower triangle
  int size_of_entries() const { return static_cast<int>(indices.size()); }

  /// the position of entry (i, j) among the stored ones, -1 if there is none; O(log degree)
  /// \pre i >= j
  int find(int i, int j) const
  {
    const auto begin = indices.begin() + offsets[static_cast<std::size_t>(j)];
    const auto end = indices.begin() + offsets[static_cast<std::size_t>(j) + 1];
    const auto it = std::lower_bound(begin, end, i);
    return it != end && *it == i ? static_cast<int>(it - indices.begin()) : -1;
  }

  friend bool operator==(const Sparse_pattern& a, const Sparse_pattern& b)
  {
    return a.offsets == b.offsets && a.indices == b.indices;
  }
};

}  // namespace Conformal_geometry_processing

#endif
