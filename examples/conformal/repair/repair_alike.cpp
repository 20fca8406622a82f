// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "repair_alike.h"

#include "conformal/process/Failure.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <string>
#include <utility>

namespace conformal {
namespace {

constexpr double negligible = 1e-6;  // precision of files with seven digits

const char* const advice = "; try: repair both in a mesh editor";

Eigen::Vector3d point(const std::vector<Point>& points, int v)
{
  return Eigen::Vector3d::Map(points[static_cast<std::size_t>(v)].data());
}

/// Considers only vertices with a face, because others may lie anywhere
double diagonal(const Surface_file& file)
{
  Eigen::AlignedBox3d box;
  for (const int v : file.polygons.corners) box.extend(point(file.points, v));
  return (box.max() - box.min()).stableNorm();
}

/// how far apart two vertices are, in diagonals
double distance(const std::vector<Point>& points, int v, int w, double diagonal)
{
  return (point(points, v) - point(points, w)).stableNorm() / diagonal;
}

void require_united(const Surface_file& file, const Repair& first)
{
  const double size = diagonal(file), size_of_first = diagonal(first.before);
  for (std::size_t i = 0; i < first.new_vertex.size(); ++i) {
    const int v = static_cast<int>(i), now = first.new_vertex[i];
    const int w = now < 0 ? v : first.vertex_in_file[static_cast<std::size_t>(now)];
    if (w == v) continue;
    if (!(distance(file.points, v, w, size) <=
          2 * distance(first.before.points, v, w, size_of_first) + negligible))
      throw unsuitable(file.path, "vertices " + std::to_string(w) + " and " + std::to_string(v) +
                                      " are one since " + first.before.path +
                                      " was repaired, but lie apart here" + advice);
  }
}

/// area over the longest edge squared
double relative_area(const std::vector<Point>& points, const std::array<int, 3>& v)
{
  Eigen::Matrix3d edges;
  for (std::size_t k = 0; k < 3; ++k)
    edges.col(static_cast<Eigen::Index>(k)) = point(points, v[(k + 1) % 3]) - point(points, v[k]);
  const double longest = edges.cwiseAbs().maxCoeff();
  if (!(longest > 0)) return 0;
  edges /= longest;
  return edges.col(0).cross(edges.col(1)).norm() / 2 / edges.colwise().squaredNorm().maxCoeff();
}

void require_flat(const Surface_file& file, const Repair& first)
{
  for (const std::array<int, 3>& v : first.removed_triangles)
    if (!(relative_area(file.points, v) <= negligible))
      throw unsuitable(file.path, "the triangle of vertices " + std::to_string(v[0]) + ", " +
                                      std::to_string(v[1]) + " and " + std::to_string(v[2]) +
                                      " has area zero in " + first.before.path +
                                      " and was removed, but not here" + advice);
}

}  // namespace

void repair_alike(Surface_file& file, const Repair& first)
{
  require_united(file, first);
  require_flat(file, first);
  std::vector<Point> own = std::exchange(file.points, first.before.points);
  const Repair done = repair(file);
  for (std::size_t i = 0; i < file.points.size(); ++i)
    file.points[i] = own[static_cast<std::size_t>(done.vertex_in_file[i])];
}

}  // namespace conformal
