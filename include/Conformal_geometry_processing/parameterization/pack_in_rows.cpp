// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/parameterization/pack_in_rows.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace Conformal_geometry_processing {

Eigen::Matrix2Xd pack_in_rows(const Eigen::Matrix2Xd& sizes, double gap)
{
  std::vector<Eigen::Index> order(static_cast<std::size_t>(sizes.cols()));
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](Eigen::Index a, Eigen::Index b) { return sizes(1, a) > sizes(1, b); });
  const double area = ((sizes.row(0).array() + gap) * (sizes.row(1).array() + gap)).sum();
  Eigen::Matrix2Xd corners(2, sizes.cols());
  double x = 0, y = 0, height = 0;
  for (const Eigen::Index i : order) {
    if (x > 0 && x + sizes(0, i) / 2 > std::sqrt(area)) {
      x = 0;
      y += height + gap;
    }
    if (x == 0) height = sizes(1, i);  // the highest in its row
    corners.col(i) << x, y;
    x += sizes(0, i) + gap;
  }
  return corners;
}

}  // namespace Conformal_geometry_processing
