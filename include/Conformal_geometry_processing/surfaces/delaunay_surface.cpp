// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/surfaces/delaunay_surface.h>

#include <Conformal_geometry_processing/exceptions.h>

#include <Eigen/Core>

#include <cmath>
#include <string>
#include <utility>

namespace Conformal_geometry_processing {
internal::Delaunay_meridian::Delaunay_meridian(double neck, double bulge) : m_bulge(bulge)
{
  if (!(neck > -bulge && neck <= bulge && neck != 0 && std::isfinite(bulge)))
    throw Precondition_error("Delaunay_meridian",
                             "the radii are " + std::to_string(neck) + " and " +
                                 std::to_string(bulge) +
                                 ", wanted -bulge < neck <= bulge and neck not zero");
  m_H = 1 / (bulge + neck);
  m_force = m_H * bulge * neck;
  m_functions = Jacobi_functions(std::abs(neck) / bulge);
  m_period = 2 * m_functions.quarter_period() / (m_H * bulge);
}

// By the symmetry of the meridian at bulges and necks.
Eigen::Matrix2Xd internal::Delaunay_meridian::points(int n, int count) const
{
  const double height = 2 * point(0.5).y();
  Eigen::Matrix2Xd result(2, count);
  for (int i = 0; i < count; ++i) {
    const double share = static_cast<double>(i % n) / n;
    const bool is_after_neck = share > 0.5;
    const Eigen::Vector2d p = point(is_after_neck ? 1 - share : share);
    result.col(i) << p.x(), (i / n) * height + (is_after_neck ? height - p.y() : p.y());
  }
  return result;
}

Eigen::Vector2d internal::Delaunay_meridian::point(double s) const
{
  const Jacobi_functions::Values f = m_functions(2 * s * m_functions.quarter_period());
  return {m_bulge * f.dn, m_force * s * m_period + m_bulge * f.second_integral};
}

Mesh_view delaunay_surface(double neck, double bulge, int m, int n, int periods)
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
