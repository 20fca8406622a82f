// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_ALGEBRA_SPARSE_PATTERN_H
#define CONFORMAL_GEOMETRY_PROCESSING_ALGEBRA_SPARSE_PATTERN_H

#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgAlgebra
/// \brief The pattern of a Hermitian sparse matrix: its lower triangle, column by column.
///
/// Column j holds the rows `indices[offsets[j]] ... indices[offsets[j+1] - 1]`, ascending; the
/// first one is always the diagonal, j. For a mesh, column j contains vertex j and its neighbours
/// of larger number, so the pattern has |V| + |E| entries. The real, complex and quaternionic
/// matrices of a mesh share one pattern, which never changes.
struct Sparse_pattern {
  std::vector<int> offsets;  ///< size() + 1 positions in `indices`
  std::vector<int> indices;  ///< row numbers

  /// Number of rows, which equals the number of columns
  int size() const { return offsets.empty() ? 0 : static_cast<int>(offsets.size()) - 1; }

  /// Number of stored entries of the lower triangle
  int size_of_entries() const { return static_cast<int>(indices.size()); }

  /// Position of entry (i, j) among the stored ones, -1 if it is not stored; O(log degree)
  /// \pre i >= j
  int find(int i, int j) const;

  friend bool operator==(const Sparse_pattern& a, const Sparse_pattern& b)
  {
    return a.offsets == b.offsets && a.indices == b.indices;
  }
};

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/algebra/Sparse_pattern_impl.h>
#endif

#endif
