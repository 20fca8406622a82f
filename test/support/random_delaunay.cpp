// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "support/random_delaunay.h"

namespace cgp_test {

std::vector<Eigen::Vector2d> uneven_points(const Circle& circle, double h, Random& random)
{
  std::vector<double> angles{0};
  for (int k = static_cast<int>(2 * pi * circle.radius / h); k > 0; --k)
    angles.push_back(angles.back() + 1 + .5 * random.number());
  std::vector<Eigen::Vector2d> p;
  for (std::size_t k = 0; k + 1 < angles.size(); ++k) {
    const double t = 2 * pi * angles[k] / angles.back() + .1;
    p.push_back(circle.center + circle.radius * Eigen::Vector2d(std::cos(t), std::sin(t)));
  }
  return p;
}

Mesh_view random_domain(double h, std::uint64_t seed, const std::vector<Circle>& holes)
{
  Random random(seed);
  std::vector<Eigen::Vector2d> p = uneven_points({}, h, random);
  for (const Circle& c : holes)
    for (const Eigen::Vector2d& q : uneven_points(c, h, random)) p.push_back(q);
  const auto is_free = [&](const Eigen::Vector2d& q) {
    if (q.norm() > 1 - .6 * h) return false;
    for (const Circle& c : holes)
      if ((q - c.center).norm() < c.radius + .6 * h) return false;
    for (const Eigen::Vector2d& other : p)
      if ((q - other).squaredNorm() < .45 * h * h) return false;
    return true;
  };
  for (int k = static_cast<int>(30 / (h * h)); k > 0; --k) {
    const double x = random.number(), y = random.number();
    if (is_free({x, y})) p.emplace_back(x, y);
  }
  const int n = static_cast<int>(p.size());
  Points all = Points::Zero(3, n);
  for (int v = 0; v < n; ++v) all.col(v).head<2>() = p[at(v)];
  for (const Circle& c : holes) p.push_back(c.center);  // whose faces fill the hole
  return renumbered({std::move(all), Delaunay(std::move(p)).faces(n)},
                    random_permutation(n, seed + 1));
}

}  // namespace cgp_test
