// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/adapters/Embedded_matrix.h>

#include <cstdint>
#include <limits>
#include <new>

namespace Conformal_geometry_processing::internal {

// Number of entries in the lower triangle: n diagonal blocks, stored as triangles, and full blocks.
int embedded_entries(std::int64_t n, std::int64_t blocks, std::int64_t width)
{
  const std::int64_t entries = width * (width + 1) / 2 * n + width * width * blocks;
  if (entries > (std::numeric_limits<int>::max)()) throw std::bad_alloc();
  return static_cast<int>(entries);
}

}  // namespace Conformal_geometry_processing::internal
