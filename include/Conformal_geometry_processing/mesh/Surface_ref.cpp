// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/Surface_ref.h>

namespace Conformal_geometry_processing {

double mean_edge_length(const Surface_ref& surface, const internal::Surface_part& part)
{
  Eigen::Vector2d sums(0, 0);
  for (int k = 0; k < surface.size_of_edges(); ++k)
    if (part.counts(k)) {
      const auto [i, j] = surface.ends(k);
      sums += Eigen::Vector2d((surface.position(j) - surface.position(i)).norm(), 1);
    }
  sums = part.sum(sums);
  return sums[0] / sums[1];
}

}  // namespace Conformal_geometry_processing
