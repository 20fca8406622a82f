// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "triangulation.h"

#include "ears_of.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>

namespace conformal {
namespace {

// The polygon seen along its normal (Newell's), from the side from which it is counter-clockwise.
Plane_polygon in_plane(const std::vector<Eigen::Vector3d>& polygon)
{
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  const Eigen::Vector3d origin = polygon.front();
  for (std::size_t i = 0; i < polygon.size(); ++i)
    normal += (polygon[i] - origin).cross(polygon[(i + 1) % polygon.size()] - origin);
  const Eigen::Vector3d u = normal.unitOrthogonal(), v = normal.stableNormalized().cross(u);
  Plane_polygon points;
  for (const Eigen::Vector3d& p : polygon)
    points.emplace_back(u.dot(p - origin), v.dot(p - origin));
  return points;
}

std::vector<std::array<std::size_t, 3>> triangles_of_polygon(const Surface_file& file,
                                                             std::size_t f)
{
  if (file.polygons.degree(f) == 3) return {{0, 1, 2}};
  std::vector<Eigen::Vector3d> polygon;
  double size = 0;
  for (std::size_t c = file.polygons.first[f]; c < file.polygons.first[f + 1]; ++c) {
    const auto v = static_cast<std::size_t>(file.polygons.corners[c]);
    polygon.push_back(Eigen::Vector3d::Map(file.points[v].data()));
    size = std::max(size, polygon.back().cwiseAbs().maxCoeff());
  }
  for (Eigen::Vector3d& p : polygon) p /= size > 0 ? size : 1;  // no product may overflow
  return ears_of(in_plane(polygon));
}

}  // namespace

Triangulation triangulate(const Surface_file& file)
{
  Triangulation result;
  result.corners.reserve(file.polygons.size());
  result.face_in_file.reserve(file.polygons.size());
  for (std::size_t f = 0; f < file.polygons.size(); ++f) {
    const std::size_t first = file.polygons.first[f];
    const int* corners = file.polygons.corners.data() + first;
    result.triangulated += file.polygons.degree(f) > 3;
    for (const auto& t : triangles_of_polygon(file, f)) {
      result.corners.push_back({corners[t[0]], corners[t[1]], corners[t[2]]});
      result.face_in_file.push_back(static_cast<int>(f));
      result.places.push_back({first + t[0], first + t[1], first + t[2]});
    }
  }
  return result;
}

}  // namespace conformal
