// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "support/skewed_tori.h"

namespace cgp_test {

Mesh_view twisted_torus(int n)
{
  return Conformal_geometry_processing::torus_grid(2 * n, n, n / 2, [&](int i, int j) {
    const double u = pi * i / n, v = 2 * pi * j / n;
    const double a = 1, b = .55, R = 1.6;
    const double x = a * std::cos(v), y = b * std::sin(v);
    const double r = R + x * std::cos(u / 2) - y * std::sin(u / 2);
    const double z = x * std::sin(u / 2) + y * std::cos(u / 2);
    return Eigen::Vector3d(r * std::cos(u), r * std::sin(u), z);
  });
}

Mesh_view hopf_torus(int n)
{
  Points curve(3, n);
  for (int i = 0; i < n; ++i) {
    const double t = 2 * pi * i / n, latitude = .12 * std::cos(3 * t);
    curve.col(i) << std::cos(latitude) * std::cos(t), std::cos(latitude) * std::sin(t),
        std::sin(latitude);
  }
  return scaled_to_area(Conformal_geometry_processing::Hopf_torus(curve).mesh(2 * n), 4 * pi);
}

}  // namespace cgp_test
