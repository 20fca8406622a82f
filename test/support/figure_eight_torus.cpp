// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "support/figure_eight_torus.h"

namespace cgp_test {

Mesh_view turned_torus(int m, int n, bool is_eight, int turns)
{
  const Mesh_view round = torus(2, 1, m, n);
  Points p(3, m * n);
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      const double u = 2 * pi * i / m, v = 2 * pi * j / n;
      const double x = is_eight ? std::sin(v) : std::cos(v);
      const double y = is_eight ? .6 * std::sin(2 * v) : .6 * std::sin(v);
      const double c = std::cos(turns * u), s = std::sin(turns * u), r = 3 + x * c - y * s;
      p.col(i * n + j) << r * std::cos(u), r * std::sin(u), x * s + y * c;
    }
  return {std::move(p), round.corners()};
}

}  // namespace cgp_test
