// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cmath>
#include <utility>

#include "support/meshes.h"

/// Meshes of smooth surfaces whose vertices are moved at random along the surface, by up to the
/// share `irregularity` of an edge: finer ones do not become smooth images of a regular pattern.
namespace cgp_benchmark {

const double irregularity = 0.3;

inline cgp_test::Mesh_view irregular_sphere(int level)
{
  const cgp_test::Mesh_view regular = cgp_test::icosphere(level);
  return cgp_test::projected_to_sphere(
      cgp_test::perturbed(regular, irregularity * cgp_test::mean_edge_length(regular)));
}

inline cgp_test::Mesh_view irregular_disk(int n)
{
  return cgp_test::jittered_disk(n, irregularity);
}

/// the same with the boundary of `disk(n)`
inline cgp_test::Mesh_view irregular_inside_disk(int n)
{
  const cgp_test::Mesh_view regular = cgp_test::disk(n);
  cgp_test::Points p = irregular_disk(n).positions();
  p.rightCols(6 * n) = regular.positions().rightCols(6 * n);
  return {std::move(p), regular.corners()};
}

/// the torus of revolution of radii 2 and 1 from 2n x n points
inline cgp_test::Mesh_view regular_torus(int n)
{
  return cgp_test::torus(2, 1, 2 * n, n);
}

inline cgp_test::Mesh_view irregular_torus(int n)
{
  cgp_test::Random random(1);
  const double angle = 2 * cgp_test::pi / n;
  return cgp_test::mapped(regular_torus(n), [&](const Eigen::Vector3d& p) {
    const double u = std::atan2(p.y(), p.x()) + irregularity * angle / 2 * random.number();
    const double v =
        std::atan2(p.z(), std::hypot(p.x(), p.y()) - 2) + irregularity * angle * random.number();
    const double distance = 2 + std::cos(v);
    return Eigen::Vector3d(distance * std::cos(u), distance * std::sin(u), std::sin(v));
  });
}

}  // namespace cgp_benchmark
