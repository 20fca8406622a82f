// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef TEST_SUPPORT_LIMBS_H
#define TEST_SUPPORT_LIMBS_H

#include <cmath>

#include "support/meshes.h"

/// Surfaces with limbs, on which rho adds up to large scales, and rings of curvature along them.
namespace cgp_test {

/// two balls with a neck between them along y, irregular
inline Mesh_view dumbbell(int level)
{
  const Mesh_view mesh = mapped(icosphere(level), [](const Eigen::Vector3d& p) {
    const double y = p.y(), radius = .35 + .65 * y * y;
    return Eigen::Vector3d(radius * p.x(), 2.5 * y, radius * p.z());
  });
  return perturbed(mesh, .01);
}

inline Eigen::VectorXd rings(const Mesh_view& mesh, double amplitude, double frequency)
{
  Eigen::VectorXd rho(mesh.size_of_vertices());
  for (int v = 0; v < rho.size(); ++v)
    rho[v] = amplitude * std::sin(frequency * mesh.position(v).y() + .4);
  return rho;
}

}  // namespace cgp_test

#endif
