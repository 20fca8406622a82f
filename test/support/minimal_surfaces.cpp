// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "support/minimal_surfaces.h"

namespace cgp_test {

Mesh_view enneper(const Mesh_view& plane, double c)
{
  return mapped(plane, [c](const Eigen::Vector3d& p) {
    const std::complex<double> i(0, 1), z(p.x(), p.y()), cube = c * c * z * z * z / 3.;
    return Eigen::Vector3d(std::real(z - cube), std::real(-i * (z + cube)), std::real(c * z * z));
  });
}

Eigen::Vector3d enneper_differential(const Eigen::Vector3d& p, const Eigen::Vector3d& v, double c)
{
  const std::complex<double> i(0, 1), z(p.x(), p.y()), dz(v.x(), v.y()), square = c * c * z * z;
  return {std::real((1. - square) * dz), std::real(-i * (1. + square) * dz),
          std::real(2. * c * z * dz)};
}

Points enneper_tangents(const Mesh_view& plane, double c)
{
  const auto boundary = Conformal_geometry_processing::boundary_frames(plane);
  Points tangents(3, static_cast<Eigen::Index>(boundary.vertices.size()));
  for (std::size_t k = 0; k < boundary.vertices.size(); ++k)
    tangents.col(static_cast<Eigen::Index>(k)) =
        enneper_differential(plane.position(boundary.vertices[k]), boundary.tangent(k), c);
  return tangents;
}

Mesh_view catenoid_strip(int n)
{
  return mapped(grid(4 * n, 2 * n, 4, 2), [](const Eigen::Vector3d& p) {
    const double v = p.x(), u = p.y() - 1;
    return Eigen::Vector3d(std::cosh(u) * std::cos(v), std::cosh(u) * std::sin(v), u);
  });
}

Mesh_view helicoid_strip(int n)
{
  return mapped(grid(4 * n, 2 * n, 4, 2), [](const Eigen::Vector3d& p) {
    const double v = p.x(), u = p.y() - 1;
    return Eigen::Vector3d(-std::sinh(u) * std::sin(v), std::sinh(u) * std::cos(v), -v);
  });
}

}  // namespace cgp_test
