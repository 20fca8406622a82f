// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_EXPANDED_GRAPH_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_EXPANDED_GRAPH_H

#include <Conformal_geometry_processing/algebra/Sparse_pattern.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Ordering.h>

#include <cstddef>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief the pattern of matrices whose entry (i, j) is a block of `width` x `width` numbers, where
/// `pattern` is that of the blocks.
///
/// For matrices on the vertices of a mesh that are real-linear but not quaternionic: of width 4,
/// factored by `Supernodal_cholesky<double>` with the `expanded_ordering()`. Vertex i has the rows
/// width i ... width i + width - 1.
inline Sparse_pattern expanded_pattern(const Sparse_pattern& pattern, int width)
{
  const std::size_t w = static_cast<std::size_t>(width);
  Sparse_pattern expanded;
  expanded.offsets.reserve(w * pattern.offsets.size());
  expanded.indices.reserve(w * w * pattern.indices.size());
  expanded.offsets.push_back(0);
  for (std::size_t j = 0; j + 1 < pattern.offsets.size(); ++j)
    for (int c = 0; c < width; ++c) {
      const int diagonal = pattern.offsets[j];
      for (int k = diagonal; k < pattern.offsets[j + 1]; ++k)
        for (int r = k == diagonal ? c : 0; r < width; ++r)
          expanded.indices.push_back(width * pattern.indices[static_cast<std::size_t>(k)] + r);
      expanded.offsets.push_back(expanded.size_of_entries());
    }
  return expanded;
}

/// \ingroup PkgLinearAlgebra
/// \brief an ordering of vertices as one of the rows of their blocks, which stay together.
///
/// As good as an ordering of the larger graph, which takes `width` squared times as long to find.
inline Ordering expanded_ordering(const Ordering& order, int width)
{
  Ordering expanded;
  expanded.reserve(static_cast<std::size_t>(width) * order.size());
  for (const int i : order)
    for (int r = 0; r < width; ++r) expanded.push_back(width * i + r);
  return expanded;
}

}  // namespace Conformal_geometry_processing

#endif
