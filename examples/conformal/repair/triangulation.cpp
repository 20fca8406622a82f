// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "triangulation.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace conformal {
namespace {

using Plane_point = Eigen::Vector2d;

double cross(const Plane_point& a, const Plane_point& b, const Plane_point& c)
{
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

// The polygon seen along its normal (Newell's), from the side from which it is counter-clockwise.
std::vector<Plane_point> in_plane(const std::vector<Eigen::Vector3d>& polygon)
{
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  const Eigen::Vector3d origin = polygon.front();
  for (std::size_t i = 0; i < polygon.size(); ++i)
    normal += (polygon[i] - origin).cross(polygon[(i + 1) % polygon.size()] - origin);
  const Eigen::Vector3d u = normal.unitOrthogonal(), v = normal.stableNormalized().cross(u);
  std::vector<Plane_point> points;
  for (const Eigen::Vector3d& p : polygon)
    points.emplace_back(u.dot(p - origin), v.dot(p - origin));
  return points;
}

// Cuts a simple polygon; of one that crosses itself, it makes some triangles.
class Ear_clipper {
 public:
  explicit Ear_clipper(std::vector<Plane_point> points) : m_points(std::move(points))
  {
    m_left.resize(m_points.size());
    std::iota(m_left.begin(), m_left.end(), std::size_t{0});
  }

  std::vector<std::array<std::size_t, 3>> triangles()
  {
    std::vector<std::array<std::size_t, 3>> result;
    while (m_left.size() > 3) {
      const std::size_t i = best_ear();
      result.push_back(corner(i));
      m_left.erase(m_left.begin() + static_cast<std::ptrdiff_t>(i));
    }
    result.push_back({m_left[0], m_left[1], m_left[2]});
    return result;
  }

 private:
  std::array<std::size_t, 3> corner(std::size_t i) const
  {
    const std::size_t n = m_left.size();
    return {m_left[(i + n - 1) % n], m_left[i], m_left[(i + 1) % n]};
  }

  // The ear whose cut leaves the best worst triangle; a large polygon takes the first there is.
  std::size_t best_ear() const
  {
    constexpr std::size_t large = 100;
    std::size_t best = 0;
    double best_quality = -1;
    for (std::size_t i = 0; i < m_left.size(); ++i) {
      const double quality = quality_of_cut(i);
      if (quality <= best_quality || !is_ear(i)) continue;
      best = i;
      best_quality = quality;
      if (m_left.size() > large && quality > 0) break;
    }
    return best;
  }

  double quality_of_cut(std::size_t i) const
  {
    const double q = quality(corner(i));
    if (m_left.size() != 4) return q;
    const auto opposite = corner((i + 2) % 4);
    return std::min(q, quality(opposite));
  }

  // 1 for an equilateral triangle, 0 for a flat one, negative for a dent
  double quality(const std::array<std::size_t, 3>& t) const
  {
    const Plane_point &a = m_points[t[0]], &b = m_points[t[1]], &c = m_points[t[2]];
    const double squares = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
    return squares > 0 ? 2 * std::sqrt(3.) * cross(a, b, c) / squares : 0;
  }

  bool is_ear(std::size_t i) const
  {
    const auto t = corner(i);
    return std::none_of(m_left.begin(), m_left.end(), [&](std::size_t p) {
      return p != t[0] && p != t[1] && p != t[2] && is_inside(p, t);
    });
  }

  bool is_inside(std::size_t p, const std::array<std::size_t, 3>& t) const
  {
    for (std::size_t k = 0; k < 3; ++k)
      if (cross(m_points[t[k]], m_points[t[(k + 1) % 3]], m_points[p]) < 0) return false;
    return true;
  }

  std::vector<Plane_point> m_points;
  std::vector<std::size_t> m_left;  // corners that are not cut off yet
};

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
  return Ear_clipper(in_plane(polygon)).triangles();
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
