// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <cmath>

/// Spin transformations that are known: the change rho of the curvature at a point of a surface,
/// and where that point goes.
namespace cgp_benchmark {

using Point = Eigen::Vector3d;

/// \brief the inversion in the unit sphere around a centre outside, with a reflection, of a surface
/// with known normals.
///
/// H~ |df~| = (H - 2 <p - c, N> / |p - c|^2) |df|: on the unit sphere, whose image has the radius
/// 1 / (|c|^2 - 1), this is easily seen.
struct Inversion {
  Point centre;

  double rho(const Point& p, const Point& normal) const
  {
    return -2 * (p - centre).dot(normal) / (p - centre).squaredNorm();
  }
  Point image(const Point& p) const
  {
    const Point q = (p - centre) / (p - centre).squaredNorm();
    return {q.x(), q.y(), -q.z()};
  }
};

/// the half axes of an ellipsoid without rotational symmetry
inline const Eigen::Array3d half_axes{1.3, 1, 0.8};

inline Point on_ellipsoid(const Point& on_sphere)
{
  return half_axes.matrix().asDiagonal() * on_sphere;
}

inline Point normal_of_ellipsoid(const Point& p)
{
  return (p.array() / half_axes.square()).matrix().normalized();
}

inline double curvature_of_ellipsoid(const Point& p)
{
  const Eigen::Array3d squares = half_axes.square();
  const double slope = (p.array() / squares).matrix().norm();
  return (squares.sum() - p.squaredNorm()) / (2 * squares.prod() * std::pow(slope, 3));
}

/// of the torus of revolution of radii 2 and 1
inline Point normal_of_torus(const Point& p)
{
  const double radius = std::hypot(p.x(), p.y());
  return {p.x() * (1 - 2 / radius), p.y() * (1 - 2 / radius), p.z()};
}

/// The image of the plane unit disk for constant rho with tangents at the boundary preserved: a
/// surface of revolution given by Bessel functions
inline Point image_of_disk(const Point& p, double rho)
{
  const double radius = p.norm();
  const double J0 = std::cyl_bessel_j(0, rho * radius), J1 = std::cyl_bessel_j(1, rho * radius);
  const double scale = J0 * J0 + J1 * J1;
  return {scale * p.x(), scale * p.y(), (J0 * J0 - 1) / rho};
}

/// the bump on the disk of the thesis, whose image is not known
inline double bump(const Point& p)
{
  const double s = 0.25;
  return 4 * std::exp(-(p - Point(0.2, 0.1, 0)).squaredNorm() / (2 * s * s));
}

}  // namespace cgp_benchmark
