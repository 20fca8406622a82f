// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/data/Surface_file.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace conformal {

/// \brief For each point the first one with exactly the same coordinates, which may be itself.
inline std::vector<int> merge_points(const std::vector<Point>& points)
{
  const auto point = [&](int i) -> const Point& { return points[static_cast<std::size_t>(i)]; };
  std::vector<int> order(points.size()), first(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int i, int j) { return point(i) < point(j); });
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool is_new = k == 0 || point(order[k]) != point(order[k - 1]);
    first[static_cast<std::size_t>(order[k])] =
        is_new ? order[k] : first[static_cast<std::size_t>(order[k - 1])];
  }
  return first;
}

}  // namespace conformal
