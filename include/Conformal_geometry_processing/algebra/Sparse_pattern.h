// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_ALGEBRA_SPARSE_PATTERN_H
#define CONFORMAL_GEOMETRY_PROCESSING_ALGEBRA_SPARSE_PATTERN_H

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
