// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Surface_file.h"

#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

namespace conformal {

/// a hash of coordinates that is the same for 0 and -0, which are equal
struct Hash_point {
  std::size_t operator()(const Point& p) const
  {
    std::size_t hash = 0;
    for (const double x : p) hash = (hash ^ std::hash<double>()(x)) * 0x9e3779b97f4a7c15u;
    return hash ^ (hash >> 29);
  }
};

/// Numbers points by first appearance; those of exactly equal coordinates are one.
class Vertex_merger {
 public:
  explicit Vertex_merger(std::vector<Point>& points) : m_points(points) {}

  std::int64_t vertex(const Point& point)
  {
    const auto [place, is_new] = m_vertices.try_emplace(point, static_cast<int>(m_points.size()));
    if (is_new) m_points.push_back(point);
    return place->second;
  }

 private:
  std::vector<Point>& m_points;
  std::unordered_map<Point, int, Hash_point> m_vertices;
};

}  // namespace conformal
