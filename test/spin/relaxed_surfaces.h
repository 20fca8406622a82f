// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cmath>

#include "spin/boundary_tools.h"
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

inline Curvature_potential waves_on(const Mesh_view& mesh, Curvature_potential::On on,
                                    double amplitude)
{
  const auto at_point = [=](const Eigen::Vector3d& p) {
    return amplitude * std::sin(2 * p.y() + 1) * std::cos(3 * p.x());
  };
  return on == Curvature_potential::On::vertices ? potential_on_vertices(mesh, at_point)
                                                 : potential_on_faces(mesh, at_point);
}

}  // namespace cgp_test
