// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "support/bounded_meshes.h"

namespace cgp_test {

Mesh_view single_triangle()
{
  return {points({{0, 0, 0}, {2, 0, 0}, {0, 1, 0}}), {{0, 1, 2}}};
}

Mesh_view unit_square()
{
  return {points({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}), {{0, 1, 2}, {0, 2, 3}}};
}

void add_square(Corners& corners, int i, int j, int v00, int v10, int v11, int v01)
{
  if ((i + j) % 2 == 0)
    corners.insert(corners.end(), {{v00, v10, v11}, {v00, v11, v01}});
  else
    corners.insert(corners.end(), {{v00, v10, v01}, {v10, v11, v01}});
}

Mesh_view grid(int nx, int ny, double a, double b)
{
  Points p(3, (nx + 1) * (ny + 1));
  Corners corners;
  const auto number = [nx](int i, int j) { return i + (nx + 1) * j; };
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i) {
      p.col(number(i, j)) << a * i / nx, b * j / ny, 0;
      if (i < nx && j < ny)
        add_square(corners, i, j, number(i, j), number(i + 1, j), number(i + 1, j + 1),
                   number(i, j + 1));
    }
  return {std::move(p), std::move(corners)};
}

Mesh_view cylinder(double radius, double height, int m, int n)
{
  return ring(m, n, [=](double angle, double s) {
    return Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), height * s);
  });
}

Mesh_view annulus(double inner, double outer, int m, int n)
{
  return ring(m, n, [=](double angle, double s) {
    const double r = outer + (inner - outer) * s;
    return Eigen::Vector3d(r * std::cos(angle), r * std::sin(angle), 0);
  });
}

Mesh_view disk(int n)
{
  Points p(3, 1 + 3 * n * (n + 1));
  p.col(0).setZero();
  const auto number = [](int k, int j) { return k == 0 ? 0 : 1 + 3 * k * (k - 1) + j % (6 * k); };
  Corners corners;
  for (int k = 1; k <= n; ++k) {
    for (int j = 0; j < 6 * k; ++j) {
      const double angle = 2 * pi * j / (6 * k), r = double(k) / n;
      p.col(number(k, j)) << r * std::cos(angle), r * std::sin(angle), 0;
    }
    for (int s = 0; s < 6; ++s)
      for (int j = 0; j < k; ++j) {
        const int o0 = number(k, s * k + j), o1 = number(k, s * k + j + 1);
        const int i0 = number(k - 1, s * (k - 1) + j), i1 = number(k - 1, s * (k - 1) + j + 1);
        corners.push_back({i0, o0, o1});
        if (j < k - 1) corners.push_back({i0, o1, i1});
      }
  }
  return {std::move(p), std::move(corners)};
}

Mesh_view moved_disk(int n)
{
  return mapped(disk(n), [](const Eigen::Vector3d& p) {
    const std::complex<double> z(p.x(), p.y()), w = (z + .4) / (1. + .4 * z);
    return Eigen::Vector3d(w.real(), w.imag(), 0);
  });
}

Mesh_view jittered_disk(int n, double amount, std::uint64_t seed)
{
  Random random(seed);
  return mapped(disk(n), [&](const Eigen::Vector3d& p) {
    const double x = amount / n * random.number(), y = amount / n * random.number();
    const Eigen::Vector3d q = p + Eigen::Vector3d(x, y, 0);
    return Eigen::Vector3d(p.norm() > 1 - 1e-9 ? q.normalized() : q);
  });
}

Mesh_view cap_from_disk(const Mesh_view& disk, double alpha)
{
  return mapped(disk, [alpha](const Eigen::Vector3d& p) {
    const Eigen::Vector3d w = std::tan(alpha / 2) * p;
    return Eigen::Vector3d(Eigen::Vector3d(2 * w.x(), 2 * w.y(), 1 - w.squaredNorm()) /
                           (1 + w.squaredNorm()));
  });
}

}  // namespace cgp_test
