// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SURFACES_DELAUNAY_SURFACE_H
#define CONFORMAL_GEOMETRY_PROCESSING_SURFACES_DELAUNAY_SURFACE_H

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

#include <cmath>
#include <string>
#include <utility>

namespace Conformal_geometry_processing {

namespace internal {

/// half of the period of dn for the complementary modulus k'
inline double quarter_period(double complementary)
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

/// \ingroup PkgSurfaces
/// \brief the meridian of a surface of revolution of constant mean curvature, as a function of its
/// conformal length u: distances from the axis, and heights.
///
/// The force along the axis is the same everywhere, x dz/ds - H x^2 = c, and du = ds/x. So
/// dz/du = c + H x^2 and (dx/du)^2 = x^2 - (dz/du)^2, hence d^2x/du^2 = (1 - 2 H c) x - 2 H^2 x^3:
/// x = bulge dn(H bulge u).
class Delaunay_meridian {
 public:
  /// \param neck, bulge the least and the largest distance from the axis, the former negative for
  /// nodoids, whose meridian has loops: neck = bulge is the cylinder, neck -> 0 a chain of spheres
  /// \throw Precondition_error unless bulge >= |neck| > 0 and neck > -bulge, both finite
  Delaunay_meridian(double neck, double bulge) : m_bulge(bulge)
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

  /// H of the surface with normals away from the axis at the bulge
  double mean_curvature() const { return m_H; }

  /// the conformal length from one bulge to the next; pi / (H bulge) for the cylinder
  double period() const { return m_period; }

  /// \brief points at equal steps of u, from a bulge at height zero, with n steps to each period.
  /// \param count how many, 2 x count
  Eigen::Matrix2Xd points(int n, int count) const
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

 private:
  Eigen::Vector3d derivative(const Eigen::Vector3d& s) const
  {
    const double x = s[0], slope = m_force + m_H * x * x;
    return {s[1], x * (1 - 2 * m_H * slope), slope};
  }

  // A step of the method of Runge and Kutta: the error of a period is below 1e-10 of it.
  Eigen::Vector3d after(const Eigen::Vector3d& s, double h) const
  {
    const Eigen::Vector3d a = derivative(s), b = derivative(s + h / 2 * a),
                          c = derivative(s + h / 2 * b), d = derivative(s + h * c);
    return s + h / 6 * (a + 2 * b + 2 * c + d);
  }

  double m_bulge, m_H, m_force, m_period;
};

/// \ingroup PkgSurfaces
/// \brief a piece of a Delaunay surface, an unduloid or a nodoid, about the axis z: constant mean
/// curvature 1 / (bulge + neck). Its two boundary loops are at bulges.
///
/// Its faces are near halves of one rectangle, conformally.
/// \param neck, bulge as for `Delaunay_meridian`
/// \param m how many vertices go around the axis
/// \param n how many rows a period has
/// \param periods how many there are
/// \throw Precondition_error if the radii are unsuitable, m < 3, or n or periods < 1
inline Mesh_view delaunay_surface(double neck, double bulge, int m, int n, int periods = 1)
{
  const Delaunay_meridian meridian(neck, bulge);
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
