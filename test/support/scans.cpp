// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "support/scans.h"

namespace cgp_test {

Points scattered_points(int n, std::uint64_t seed)
{
  Random random(seed);
  const double distance = std::sqrt(4 * pi / n) / 3;
  Points p(3, n);
  for (int i = 0; i < n;) {
    const Eigen::Vector3d candidate = random.vector();
    if (candidate.norm() > 1) continue;
    p.col(i) = candidate.normalized();
    if (i == 0 || (p.leftCols(i).colwise() - p.col(i)).colwise().norm().minCoeff() > distance) ++i;
  }
  return p;
}

Corners convex_hull(const Points& p)
{
  const auto volume = [&](int a, int b, int c, Eigen::Index d) {
    const Eigen::Vector3d ab = p.col(b) - p.col(a), ac = p.col(c) - p.col(a);
    return ab.cross(ac).dot(p.col(d) - p.col(a));
  };
  Corners hull{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  if (volume(0, 1, 2, 3) > 0)
    for (auto& v : hull) std::swap(v[1], v[2]);
  for (int i = 4; i < p.cols(); ++i) {
    Corners kept;
    std::set<std::array<int, 2>> horizon;  // edges of faces that see the point, of one alone
    for (const auto& v : hull) {
      if (volume(v[0], v[1], v[2], i) <= 0) {
        kept.push_back(v);
        continue;
      }
      for (int k = 0; k < 3; ++k) {
        const int a = v[at(k)], b = v[at((k + 1) % 3)];
        if (horizon.erase({b, a}) == 0) horizon.insert({a, b});
      }
    }
    for (const auto& [a, b] : horizon) kept.push_back({a, b, i});
    hull = std::move(kept);
  }
  return hull;
}

Mesh_view scan(int n, double noise, std::uint64_t seed)
{
  Points p = scattered_points(n, seed);
  Corners corners = convex_hull(p);
  const Points limbs = points({{1, 0.2, 0}, {-0.7, 0.8, 0.1}, {-0.4, -0.9, 0.3}, {0.1, 0.3, 1}});
  Random random(seed + 1);
  for (Eigen::Index v = 0; v < n; ++v) {
    double radius = 0.7;
    for (Eigen::Index k = 0; k < limbs.cols(); ++k)
      radius += 0.6 * std::exp(8 * (limbs.col(k).normalized().dot(p.col(v)) - 1));
    p.col(v) *= radius * (1 + noise * random.number());
  }
  return {std::move(p), std::move(corners)};
}

}  // namespace cgp_test
