// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "support/fibonacci_sphere.h"

namespace cgp_test {

Mesh_view fibonacci_sphere(int n)
{
  const double turn = pi * (3 - std::sqrt(5.));
  const std::vector<int> order = random_permutation(n, 7);  // the hull begins with any four
  Points p(3, n);
  for (int i = 0; i < n; ++i) {
    const double z = 1 - (2 * i + 1.) / n, r = std::sqrt(1 - z * z);
    p.col(order[at(i)]) << r * std::cos(turn * i), r * std::sin(turn * i), z;
  }
  Corners corners = convex_hull(p);
  return {std::move(p), std::move(corners)};
}

}  // namespace cgp_test
