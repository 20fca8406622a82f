// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/direct/expanded_graph.h>

#include <cstddef>

namespace Conformal_geometry_processing {

Sparse_pattern expanded_pattern(const Sparse_pattern& pattern, int width)
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

internal::Ordering expanded_ordering(const internal::Ordering& order, int width)
{
  internal::Ordering expanded;
  expanded.reserve(static_cast<std::size_t>(width) * order.size());
  for (const int i : order)
    for (int r = 0; r < width; ++r) expanded.push_back(width * i + r);
  return expanded;
}

}  // namespace Conformal_geometry_processing
