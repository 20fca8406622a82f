// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cmath>

#include "spin/boundary_tools.h"
#include "support/bounded_meshes.h"
#include "support/meshes.h"

/// The surfaces and potentials on which relaxed spins are tried.
namespace cgp_test {

inline Mesh_view ellipsoid(int level)
{
  const auto stretched = [](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(p.x(), 2 * p.y(), p.z());
  };
  return perturbed(mapped(icosphere(level), stretched), .02);
}

/// a cap with irregular faces
inline Mesh_view bounded_cap()
{
  return cap_from_disk(jittered_disk(8, .2), 1.2);
}

inline Eigen::VectorXd waves_on(const Mesh_view& mesh, double amplitude)
{
  return potential_on_vertices(mesh,
                               [=](const Eigen::Vector3d& p) {
                                 return amplitude * std::sin(2 * p.y() + 1) * std::cos(3 * p.x());
                               })
      .values;
}

}  // namespace cgp_test
