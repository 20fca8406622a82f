// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "support/tori.h"

namespace cgp_test {

Mesh_view torus(double R, double r, int m, int n)
{
  return tube_torus(R, m, n, [r](double, double) { return r; });
}

Mesh_view irregular_torus(double R, double r, int m, int n)
{
  Random random(1);
  return Conformal_geometry_processing::torus_grid(m, n, 0, [&](int i, int j) {
    const double u = 2 * pi * (i + .3 * random.number()) / m;
    const double v = 2 * pi * (j + .3 * random.number()) / n, distance = R + r * std::cos(v);
    return Eigen::Vector3d(distance * std::cos(u), distance * std::sin(u), r * std::sin(v));
  });
}

Mesh_view btorus(int n)
{
  const auto radius = [](double u, double v) {
    return 1 + .1 * std::cos(4 * pi * u + 2 * pi * v) + .06 * std::sin(6 * pi * v);
  };
  return scaled_to_area(tube_torus(std::sqrt(2.), n, n, radius), 4 * pi);
}

Mesh_view storus(int n)
{
  const auto radius = [](double u, double v) {
    return 1 + .12 * std::cos(4 * pi * u) * std::cos(2 * pi * v) + .05 * std::cos(6 * pi * v);
  };
  return scaled_to_area(tube_torus(std::sqrt(2.), n, n, radius), 4 * pi);
}

}  // namespace cgp_test
