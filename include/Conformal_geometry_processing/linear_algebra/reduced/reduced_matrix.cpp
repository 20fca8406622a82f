// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/reduced/reduced_matrix.h>

#include <cstddef>
#include <memory>

namespace Conformal_geometry_processing {

std::shared_ptr<const Sparse_pattern> reduced_pattern(const Sparse_pattern& pattern,
                                                      const internal::Reduced_rows& rows)
{
  auto reduced = std::make_shared<Sparse_pattern>();
  reduced->offsets.reserve(static_cast<std::size_t>(rows.dimension()) + 1);
  reduced->indices.reserve(16 * pattern.indices.size());
  reduced->offsets.push_back(0);
  for (int j = 0; j < pattern.size(); ++j)
    for (int c = 0; c < rows.dimension(j); ++c) {
      const int begin = pattern.offsets[static_cast<std::size_t>(j)];
      for (int k = begin; k < pattern.offsets[static_cast<std::size_t>(j) + 1]; ++k) {
        const int i = pattern.indices[static_cast<std::size_t>(k)];
        for (int r = k == begin ? c : 0; r < rows.dimension(i); ++r)
          reduced->indices.push_back(rows.first(i) + r);
      }
      reduced->offsets.push_back(static_cast<int>(reduced->indices.size()));
    }
  return reduced;
}

internal::Ordering reduced_ordering(const internal::Ordering& order,
                                    const internal::Reduced_rows& rows)
{
  internal::Ordering coordinates;
  coordinates.reserve(static_cast<std::size_t>(rows.dimension()));
  for (int i : order)
    for (int c = 0; c < rows.dimension(i); ++c) coordinates.push_back(rows.first(i) + c);
  return coordinates;
}

}  // namespace Conformal_geometry_processing
