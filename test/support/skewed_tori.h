// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef TEST_SUPPORT_SKEWED_TORI_H
#define TEST_SUPPORT_SKEWED_TORI_H

#include <cmath>
#include <utility>

#include "support/mesh_tools.h"

/// Tori whose grid comes back to itself with a shift: no reflection keeps their conformal class
/// rectangular.
namespace cgp_test {

/// m x n points; after one turn around the axis the point n/2 further follows
/// \param point a function of two angles u, v with point(u + 2 pi, v) = point(u, v + pi)
template <class Point>
Mesh_view half_turned_torus(int m, int n, Point point)
{
  const auto number = [&](int i, int j) { return i % m * n + (j + (i == m ? n / 2 : 0)) % n; };
  Points p(3, m * n);
  Corners corners;
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      p.col(number(i, j)) = point(2 * pi * i / m, 2 * pi * j / n);
      corners.push_back({number(i, j), number(i + 1, j), number(i + 1, j + 1)});
      corners.push_back({number(i, j), number(i + 1, j + 1), number(i, j + 1)});
    }
  return {std::move(p), std::move(corners)};
}

/// an elliptic cross-section that turns by pi around the axis: of no symmetry but rotations
inline Mesh_view twisted_torus(int n)
{
  return half_turned_torus(2 * n, n, [](double u, double v) {
    const double a = 1, b = .55, R = 1.6;
    const double x = a * std::cos(v), y = b * std::sin(v);
    const double r = R + x * std::cos(u / 2) - y * std::sin(u / 2);
    const double z = x * std::sin(u / 2) + y * std::cos(u / 2);
    return Eigen::Vector3d(r * std::cos(u), r * std::sin(u), z);
  });
}

/// the circles over the curve of latitude 0.12 cos(3 t), t its longitude, in the Hopf fibration of
/// the 3-sphere, projected to space from a point that is not on it: area 4 pi. The smooth one has
/// pi times the integral of 1 + curvature^2 along the curve as its Willmore energy.
inline Mesh_view hopf_torus(int n)
{
  const auto point = [](double t, double phi) {
    const double alpha = pi / 4 + .06 * std::cos(3 * t);
    const double c = std::cos(alpha), s = std::sin(alpha), a = phi - t / 2, b = phi + t / 2;
    const double scale = 1 / (1 - s * std::cos(b));
    return Eigen::Vector3d(scale * c * std::cos(a), scale * c * std::sin(a),
                           scale * s * std::sin(b));
  };
  return scaled_to_area(half_turned_torus(n, 2 * n, point), 4 * pi);
}

}  // namespace cgp_test

#endif
