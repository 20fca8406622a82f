// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/direct/Graph_region.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace Conformal_geometry_processing {

internal::Graph_region graph_region(const Sparse_pattern& pattern,
                                    const Eigen::Matrix3Xd& positions)
{
  internal::Graph_region region;
  const int n = pattern.size();
  region.vertices.resize(static_cast<std::size_t>(n));
  std::iota(region.vertices.begin(), region.vertices.end(), 0);
  region.edges.reserve(pattern.indices.size() - region.vertices.size());
  for (int j = 0; j < n; ++j)
    for (int k = pattern.offsets[static_cast<std::size_t>(j)] + 1;
         k < pattern.offsets[static_cast<std::size_t>(j) + 1]; ++k)
      region.edges.push_back({j, pattern.indices[static_cast<std::size_t>(k)]});
  if (n == 0) return region;
  const Eigen::Vector3d low = positions.rowwise().minCoeff(), high = positions.rowwise().maxCoeff();
  const Eigen::Vector3d center = low / 2 + high / 2;  // low + high may overflow
  const double radius = (high / 2 - low / 2).maxCoeff();
  region.positions.resize(n, 3);
  for (int a = 0; a < 3; ++a)
    if (radius > 0)
      region.positions.col(a) =
          ((positions.row(a).transpose().array() - center[a]) / radius).cast<float>();
    else
      region.positions.col(a).setZero();
  return region;
}

std::array<internal::Graph_region, 2> split(const internal::Graph_region& region,
                                            const std::vector<internal::Side>& sides)
{
  std::array<internal::Graph_region, 2> parts;
  std::vector<int> place(sides.size(), -1);  // local index; -1 for the separator
  const auto part_of = [&](int v) -> internal::Graph_region& {
    return parts[sides[static_cast<std::size_t>(v)] == internal::Side::left ? 0 : 1];
  };
  for (int v = 0; v < region.size(); ++v)
    if (sides[static_cast<std::size_t>(v)] != internal::Side::separator) {
      place[static_cast<std::size_t>(v)] = part_of(v).size();
      part_of(v).vertices.push_back(region.vertices[static_cast<std::size_t>(v)]);
    }
  for (internal::Graph_region& part : parts) part.positions.resize(part.size(), 3);
  for (int v = 0; v < region.size(); ++v)
    if (place[static_cast<std::size_t>(v)] >= 0)
      part_of(v).positions.row(place[static_cast<std::size_t>(v)]) = region.positions.row(v);
  for (const auto& e : region.edges) {
    const int a = place[static_cast<std::size_t>(e[0])], b = place[static_cast<std::size_t>(e[1])];
    if (a >= 0 && b >= 0) part_of(e[0]).edges.push_back({a, b});
  }
  return parts;
}

}  // namespace Conformal_geometry_processing
