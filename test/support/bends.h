// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef TEST_SUPPORT_BENDS_H
#define TEST_SUPPORT_BENDS_H

#include <cmath>

#include "support/polyhedra.h"

/// A beam, and what can be done to it.
namespace cgp_test {

/// the block 1 x 1 x 6 with n quads along its short edges
inline Mesh_view beam(int n)
{
  return scaled(block(n, n, 6 * n), 1. / n);
}

/// the beam as the arc of a circle by an angle; in the plane y = `neutral` lengths stay
inline Mesh_view bent_beam(const Mesh_view& mesh, double angle, double neutral = 0)
{
  return mapped(mesh, [=](const Eigen::Vector3d& p) {
    const double radius = 6 / angle + p.y() - neutral, a = angle * p.z() / 6;
    return Eigen::Vector3d(p.x(), radius * std::cos(a), radius * std::sin(a));
  });
}

/// the beam with its end turned about its axis by an angle
inline Mesh_view twisted_beam(const Mesh_view& mesh, double angle)
{
  return mapped(mesh, [=](const Eigen::Vector3d& p) {
    const double a = angle * p.z() / 6, x = p.x() - 0.5, y = p.y() - 0.5;
    return Eigen::Vector3d(x * std::cos(a) - y * std::sin(a), x * std::sin(a) + y * std::cos(a),
                           p.z());
  });
}

}  // namespace cgp_test

#endif
