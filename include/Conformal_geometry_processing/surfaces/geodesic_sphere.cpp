// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/surfaces/geodesic_sphere.h>

#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

/// Vertices (+-1, +-phi, 0) and cyclic permutations, faces counter-clockwise seen from outside
Mesh_view icosahedron()
{
  const double g = (1 + std::sqrt(5.)) / 2;
  Points p(3, 12);
  p << -1, 1, -1, 1, 0, 0, 0, 0, g, g, -g, -g,  //
      g, g, -g, -g, -1, 1, -1, 1, 0, 0, 0, 0,   //
      0, 0, 0, 0, g, g, -g, -g, -1, 1, -1, 1;
  return {std::move(p),
          {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
           {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
           {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
}

/// Numbers the points of evenly subdivided faces; points on edges are shared.
class Geodesic_points {
 public:
  /// \param frequency the number of parts of an edge
  explicit Geodesic_points(int frequency) : m_frequency(frequency), m_base(icosahedron()) {}

  const Mesh_view& base() const { return m_base; }
  Points points() const
  {
    return Eigen::Map<const Points>(m_points.front().data(), 3,
                                    static_cast<Eigen::Index>(m_points.size()));
  }

  /// The point with these barycentric coordinates, times the frequency, in face f
  int number(int f, const std::array<int, 3>& weights)
  {
    std::map<int, int> key;  // from corners to weights, without zero weights
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    for (std::size_t c = 0; c < 3; ++c) {
      if (weights[c] == 0) continue;
      key[m_base.corners(f)[c]] = weights[c];
      p += weights[c] * m_base.position(m_base.corners(f)[c]);
    }
    const auto [place, is_new] = m_numbers.emplace(key, static_cast<int>(m_points.size()));
    if (is_new) m_points.push_back((p / m_frequency).normalized());
    return place->second;
  }

 private:
  int m_frequency;
  Mesh_view m_base;
  std::vector<Eigen::Vector3d> m_points;
  std::map<std::map<int, int>, int> m_numbers;
};

}  // namespace internal

Mesh_view geodesic_sphere(int frequency)
{
  if (frequency < 1)
    throw Precondition_error("geodesic_sphere", "the frequency is " + std::to_string(frequency) +
                                                    ", wanted at least one");
  internal::Geodesic_points points(frequency);
  Mesh_view::Corners corners;
  for (int f = 0; f < points.base().size_of_faces(); ++f)
    for (int i = 0; i < frequency; ++i)
      for (int j = 0; j < frequency - i; ++j) {
        const int k = frequency - i - j;
        const int a = points.number(f, {k, i, j}), b = points.number(f, {k - 1, i + 1, j}),
                  c = points.number(f, {k - 1, i, j + 1});
        corners.push_back({a, b, c});
        if (k > 1) corners.push_back({b, points.number(f, {k - 2, i + 1, j + 1}), c});
      }
  return {points.points(), std::move(corners)};
}

}  // namespace Conformal_geometry_processing
