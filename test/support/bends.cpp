// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "support/bends.h"

namespace cgp_test {

Mesh_view beam(int n)
{
  return scaled(block(n, n, 6 * n), 1. / n);
}

Mesh_view bent_beam(const Mesh_view& mesh, double angle, double neutral)
{
  return mapped(mesh, [=](const Eigen::Vector3d& p) {
    const double radius = 6 / angle + p.y() - neutral, a = angle * p.z() / 6;
    return Eigen::Vector3d(p.x(), radius * std::cos(a), radius * std::sin(a));
  });
}

Mesh_view twisted_beam(const Mesh_view& mesh, double angle)
{
  return mapped(mesh, [=](const Eigen::Vector3d& p) {
    const double a = angle * p.z() / 6, x = p.x() - 0.5, y = p.y() - 0.5;
    return Eigen::Vector3d(x * std::cos(a) - y * std::sin(a), x * std::sin(a) + y * std::cos(a),
                           p.z());
  });
}

}  // namespace cgp_test
