// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "triangulation.h"

#include "ears_of.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>

namespace conformal {
namespace {

// The polygon seen along its normal (Newell's), from the side from which it is counter-clockwise.
Plane_polygon in_plane(const std::vector<Eigen::Vector3d>& polygon)
{
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  const Eigen::Vector3d origin = polygon.front();
  for (std::size_t i = 0; i < polygon.size(); ++i)
    normal += (polygon[i] - origin).cross(polygon[(i + 1) % polygon.size()] - origin);
  if (normal.isZero(0)) normal.setUnit(2);  // a polygon there and back: any plane
  const Eigen::Vector3d u = normal.unitOrthogonal(), v = normal.stableNormalized().cross(u);
  Plane_polygon points;
  for (const Eigen::Vector3d& p : polygon)
    points.emplace_back(u.dot(p - origin), v.dot(p - origin));
  return points;
}

}  // namespace

std::vector<std::array<std::size_t, 3>> triangles_of(const Surface_file& file,
                                                     const std::vector<std::size_t>& places)
{
  if (places.size() == 3) return {{places[0], places[1], places[2]}};
  std::vector<Eigen::Vector3d> polygon;
  double size = 0;
  for (const std::size_t c : places) {
    const auto v = static_cast<std::size_t>(file.polygons.corners[c]);
    polygon.push_back(Eigen::Vector3d::Map(file.points[v].data()));
    size = std::max(size, polygon.back().cwiseAbs().maxCoeff());
  }
  for (Eigen::Vector3d& p : polygon) p /= size > 0 ? size : 1;  // no product may overflow
  auto triangles = ears_of(in_plane(polygon));
  for (auto& triangle : triangles)
    for (std::size_t& corner : triangle) corner = places[corner];
  return triangles;
}

Triangulation triangulate(const Surface_file& file)
{
  Triangulation result;
  result.corners.reserve(file.polygons.size());
  result.face_in_file.reserve(file.polygons.size());
  for (std::size_t f = 0; f < file.polygons.size(); ++f) {
    const std::vector<int>& corners = file.polygons.corners;
    std::vector<std::size_t> places(file.polygons.degree(f));
    std::iota(places.begin(), places.end(), file.polygons.first[f]);
    result.triangulated += places.size() > 3;
    for (const auto& t : triangles_of(file, places)) {
      result.corners.push_back({corners[t[0]], corners[t[1]], corners[t[2]]});
      result.face_in_file.push_back(static_cast<int>(f));
      result.places.push_back(t);
    }
  }
  return result;
}

}  // namespace conformal
