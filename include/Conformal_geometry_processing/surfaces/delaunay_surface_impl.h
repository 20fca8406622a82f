// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SURFACES_DELAUNAY_SURFACE_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_SURFACES_DELAUNAY_SURFACE_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/surfaces/delaunay_surface.h>

#include <Eigen/Core>

#include <cmath>
#include <string>
#include <utility>

namespace Conformal_geometry_processing {
namespace internal {

/// Half of the period of dn for the complementary modulus k'
CGP_INLINE double quarter_period(double complementary)
{
  double a = 1, g = complementary;
  while (std::abs(a - g) > 1e-15 * a) {
    const double mean = (a + g) / 2;
    g = std::sqrt(a * g);
    a = mean;
  }
  return 2 * std::atan(1.) / a;
}

}  // namespace internal

CGP_INLINE internal::Delaunay_meridian::Delaunay_meridian(double neck, double bulge)
    : m_bulge(bulge)
{
  if (!(neck > -bulge && neck <= bulge && neck != 0 && std::isfinite(bulge)))
    throw Precondition_error("Delaunay_meridian",
                             "the radii are " + std::to_string(neck) + " and " +
                                 std::to_string(bulge) +
                                 ", wanted -bulge < neck <= bulge and neck not zero");
  m_H = 1 / (bulge + neck);
  m_force = m_H * bulge * neck;
  m_period = 2 * internal::quarter_period(std::abs(neck) / bulge) / (m_H * bulge);
}

CGP_INLINE Eigen::Matrix2Xd internal::Delaunay_meridian::points(int n, int count) const
{
  const int parts = 1 + static_cast<int>(2000. / n);
  const double h = m_period / n / parts;
  Eigen::Vector3d state(m_bulge, 0, 0);  // x, dx/du, z
  Eigen::Matrix2Xd result(2, count);
  for (int i = 0; i < count; ++i) {
    result.col(i) << state[0], state[2];
    for (int k = 0; k < parts; ++k) state = after(state, h);
  }
  return result;
}

CGP_INLINE Eigen::Vector3d internal::Delaunay_meridian::derivative(const Eigen::Vector3d& s) const
{
  const double x = s[0], slope = m_force + m_H * x * x;
  return {s[1], x * (1 - 2 * m_H * slope), slope};
}

// A Runge-Kutta step: the relative error of a period is below 1e-10.
CGP_INLINE Eigen::Vector3d internal::Delaunay_meridian::after(const Eigen::Vector3d& s,
                                                              double h) const
{
  const Eigen::Vector3d a = derivative(s), b = derivative(s + h / 2 * a),
                        c = derivative(s + h / 2 * b), d = derivative(s + h * c);
  return s + h / 6 * (a + 2 * b + 2 * c + d);
}

CGP_INLINE Mesh_view delaunay_surface(double neck, double bulge, int m, int n, int periods)
{
  const internal::Delaunay_meridian meridian(neck, bulge);
  if (m < 3 || n < 1 || periods < 1)
    throw Precondition_error(
        "delaunay_surface", std::to_string(periods) + " periods of a grid of " + std::to_string(m) +
                                " x " + std::to_string(n) +
                                "; wanted three vertices around the axis, and one row");
  const int rows = n * periods;
  const Eigen::Matrix2Xd profile = meridian.points(n, rows + 1);
  Points p(3, m * (rows + 1));
  Mesh_view::Corners corners;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i < m; ++i) {
      const double u = 8 * std::atan(1.) * i / m;
      p.col(j * m + i) << profile(0, j) * std::cos(u), profile(0, j) * std::sin(u), profile(1, j);
      if (j == rows) continue;
      const int a = j * m + i, b = j * m + (i + 1) % m;
      corners.push_back({a, b, b + m});
      corners.push_back({a, b + m, a + m});
    }
  return {std::move(p), std::move(corners)};
}

}  // namespace Conformal_geometry_processing

#endif
