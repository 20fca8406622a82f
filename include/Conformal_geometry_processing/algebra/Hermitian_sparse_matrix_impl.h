// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_ALGEBRA_HERMITIAN_SPARSE_MATRIX_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_ALGEBRA_HERMITIAN_SPARSE_MATRIX_IMPL_H

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/config.h>

#include <algorithm>
#include <cstddef>

namespace Conformal_geometry_processing {

CGP_INLINE int Sparse_pattern::find(int i, int j) const
{
  const auto begin = indices.begin() + offsets[static_cast<std::size_t>(j)];
  const auto end = indices.begin() + offsets[static_cast<std::size_t>(j) + 1];
  const auto it = std::lower_bound(begin, end, i);
  return it != end && *it == i ? static_cast<int>(it - indices.begin()) : -1;
}

}  // namespace Conformal_geometry_processing

#endif
