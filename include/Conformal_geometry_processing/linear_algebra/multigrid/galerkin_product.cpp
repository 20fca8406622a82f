// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/multigrid/galerkin_product.h>

#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing::internal {

Sparse_rows<float> transpose(const Prolongation& P)
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

}  // namespace Conformal_geometry_processing::internal
