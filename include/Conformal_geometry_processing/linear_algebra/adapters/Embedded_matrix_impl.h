// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_ADAPTERS_EMBEDDED_MATRIX_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_ADAPTERS_EMBEDDED_MATRIX_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/linear_algebra/adapters/Embedded_matrix.h>

#include <cstdint>
#include <limits>
#include <new>

namespace Conformal_geometry_processing {
namespace internal {

// Number of entries in the lower triangle: n diagonal blocks, stored as triangles, and full blocks.
CGP_INLINE int embedded_entries(std::int64_t n, std::int64_t blocks, std::int64_t width)
{
  const std::int64_t entries = width * (width + 1) / 2 * n + width * width * blocks;
  if (entries > (std::numeric_limits<int>::max)()) throw std::bad_alloc();
  return static_cast<int>(entries);
}

}  // namespace internal
}  // namespace Conformal_geometry_processing

#endif
