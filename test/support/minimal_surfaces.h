// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef TEST_SUPPORT_MINIMAL_SURFACES_H
#define TEST_SUPPORT_MINIMAL_SURFACES_H

#include <Conformal_geometry_processing/mesh/Boundary_frames.h>

#include <array>
#include <complex>

#include "support/bounded_meshes.h"

/// Minimal surfaces in closed form, by Weierstrass' representation: conformal images of plane
/// domains.
namespace cgp_test {

/// Enneper's surface X = Re(z - c^2 z^3/3, -i(z + c^2 z^3/3), c z^2) over a plane mesh
inline Mesh_view enneper(const Mesh_view& plane, double c = 0.8)
{
  return mapped(plane, [c](const Eigen::Vector3d& p) {
    const std::complex<double> i(0, 1), z(p.x(), p.y()), cube = c * c * z * z * z / 3.;
    return Eigen::Vector3d(std::real(z - cube), std::real(-i * (z + cube)), std::real(c * z * z));
  });
}

/// dX(v) for a vector v at the point p of the plane
inline Eigen::Vector3d enneper_differential(const Eigen::Vector3d& p, const Eigen::Vector3d& v,
                                            double c = 0.8)
{
  const std::complex<double> i(0, 1), z(p.x(), p.y()), dz(v.x(), v.y()), square = c * c * z * z;
  return {std::real((1. - square) * dz), std::real(-i * (1. + square) * dz),
          std::real(2. * c * z * dz)};
}

/// the tangents of the boundary of Enneper's surface over a plane mesh, in the order of
/// `boundary_frames()`
inline Points enneper_tangents(const Mesh_view& plane, double c = 0.8)
{
  const auto boundary = Conformal_geometry_processing::boundary_frames(plane);
  Points tangents(3, static_cast<Eigen::Index>(boundary.vertices.size()));
  for (std::size_t k = 0; k < boundary.vertices.size(); ++k)
    tangents.col(static_cast<Eigen::Index>(k)) =
        enneper_differential(plane.position(boundary.vertices[k]), boundary.tangent(k), c);
  return tangents;
}

/// a strip of the catenoid (cosh u cos v, cosh u sin v, u), |u| <= 1, 0 <= v <= 4
inline Mesh_view catenoid_strip(int n)
{
  return mapped(grid(4 * n, 2 * n, 4, 2), [](const Eigen::Vector3d& p) {
    const double v = p.x(), u = p.y() - 1;
    return Eigen::Vector3d(std::cosh(u) * std::cos(v), std::cosh(u) * std::sin(v), u);
  });
}

/// the same strip of the helicoid (-sinh u sin v, sinh u cos v, -v), to which it is isometric
inline Mesh_view helicoid_strip(int n)
{
  return mapped(grid(4 * n, 2 * n, 4, 2), [](const Eigen::Vector3d& p) {
    const double v = p.x(), u = p.y() - 1;
    return Eigen::Vector3d(-std::sinh(u) * std::sin(v), std::sinh(u) * std::cos(v), -v);
  });
}

}  // namespace cgp_test

#endif
