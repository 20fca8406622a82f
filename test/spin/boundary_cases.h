// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "spin/boundary_tools.h"

/// An uneven cap, and one condition of each kind for its boundary.
namespace cgp_test {

inline Mesh_view uneven_cap()
{
  return perturbed(cap_from_disk(jittered_disk(6, .3), 1.2), .01);
}

inline Curvature_potential rho_of_uneven_cap()
{
  return potential_on_vertices(uneven_cap(),
                               [](const Eigen::Vector3d& p) { return std::cos(4 * p.x() + 1); });
}

inline std::vector<Boundary_condition> conditions_of_uneven_cap()
{
  const Mesh_view flat = jittered_disk(6, .3), bent = perturbed(uneven_cap(), .02, 3);
  const Points points = at_boundary(bent, [](const Eigen::Vector3d& p, const auto&) { return p; });
  const Points normals = at_boundary(
      bent, [](const auto&, const auto& frame) -> Eigen::Vector3d { return frame.col(1); });
  const Eigen::Vector3d mixture(1, 1, 2);
  return {Boundary_condition::free(),
          Boundary_condition::tangents(enneper_directions(flat, {1, 0, 0})),
          Boundary_condition::binormals(),
          Boundary_condition::directions(mixture, enneper_directions(flat, mixture)),
          Boundary_condition::positions(points, normals)};
}

/// every length multiplied by s
inline Boundary_condition scaled(Boundary_condition condition, double s)
{
  condition.targets *= s;
  return condition;
}

}  // namespace cgp_test
