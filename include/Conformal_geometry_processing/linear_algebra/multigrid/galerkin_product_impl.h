// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_MULTIGRID_GALERKIN_PRODUCT_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_MULTIGRID_GALERKIN_PRODUCT_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/linear_algebra/multigrid/galerkin_product.h>

#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

CGP_INLINE Sparse_rows<float> transpose(const Prolongation& P)
{
  Sparse_rows<float> R(P.coarse_size);
  for (const int c : P.columns) ++R.offsets[static_cast<std::size_t>(c) + 1];
  std::vector<int> next = R.allocate();
  for (int i = 0; i < P.fine_size(); ++i)
    P.for_each_in_row(i, [&](int c, float weight) {
      const std::size_t k = static_cast<std::size_t>(next[static_cast<std::size_t>(c)]++);
      R.columns[k] = i;
      R.values[k] = weight;
    });
  return R;
}

}  // namespace internal
}  // namespace Conformal_geometry_processing

#endif
