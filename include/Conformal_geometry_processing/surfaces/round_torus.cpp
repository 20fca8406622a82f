// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/surfaces/round_torus.h>

#include <cmath>

namespace Conformal_geometry_processing {

Eigen::Vector3d stereographic_projection(const Quaternion<double>& q)
{
  return imaginary_part(q) / (1 - q.w);
}

Mesh_view round_torus(double R, double r, int m, int n)
{
  if (!(R > r && r > 0 && std::isfinite(R)))
    throw Precondition_error("round_torus", "the radii are " + std::to_string(R) + " and " +
                                                std::to_string(r) + ", wanted R > r > 0");
  const double s = r / R, c = std::sqrt((1 - s) * (1 + s)), turn = 2 * std::acos(-1.);
  return torus_grid(m, n, 0, [&](int i, int j) -> Eigen::Vector3d {
    const double u = turn * i / m, v = turn * j / n;
    return R * c *
           stereographic_projection(
               {s * std::cos(v), c * std::cos(u), c * std::sin(u), s * std::sin(v)});
  });
}

Mesh_view homogeneous_torus(double b, int n)
{
  if (!(b > 0) || !(b * n < 1e6))
    throw Precondition_error("homogeneous_torus",
                             "the modulus is " + std::to_string(b) + " i, wanted b positive");
  return round_torus(std::sqrt(1 + b * b), 1, static_cast<int>(std::round(b * n)), n);
}

}  // namespace Conformal_geometry_processing
