// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef TEST_FLOW_RANDOM_HULL_H
#define TEST_FLOW_RANDOM_HULL_H

#include <set>
#include <utility>

#include "support/random.h"

namespace cgp_test {

/// \brief the convex hull of n random points of the unit sphere: a Delaunay triangulation with
/// angles from a fraction of a degree up.
///
/// Each point sees some faces of the hull of the points before it; they give way to faces between
/// it and their rim. O(n^2).
inline Mesh_view random_hull(int n, std::uint64_t seed)
{
  Random random(seed);
  Points p(3, n);
  for (int v = 0; v < n; ++v) {
    Eigen::Vector3d point = random.vector();
    while (point.norm() > 1) point = random.vector();
    p.col(v) = point.normalized();
  }
  const auto sees = [&](int v, const std::array<int, 3>& face) {
    const Eigen::Vector3d a = p.col(face[0]), b = p.col(face[1]), c = p.col(face[2]);
    return (b - a).cross(c - a).dot(p.col(v) - a) > 0;
  };
  Corners hull = {{0, 1, 2}, {0, 2, 1}};
  for (int v = 3; v < n; ++v) {
    Corners hidden;
    std::set<std::pair<int, int>> edges;  // of the faces in sight
    for (const auto& face : hull) {
      if (!sees(v, face)) hidden.push_back(face);
      if (sees(v, face))
        for (std::size_t c = 0; c < 3; ++c) edges.insert({face[c], face[(c + 1) % 3]});
    }
    hull = std::move(hidden);
    for (const auto& [a, b] : edges)
      if (edges.count({b, a}) == 0) hull.push_back({a, b, v});
  }
  return {std::move(p), std::move(hull)};
}

}  // namespace cgp_test

#endif
