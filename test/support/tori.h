// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/surfaces/tori.h>

#include <cmath>

#include "support/mesh_tools.h"
#include "support/random.h"

/// Tori around the z axis: vertex i n + j is at u = i/m (around the axis), v = j/n (around the
/// tube); normals point outward.
namespace cgp_test {

/// \param radius of the tube, a function of (u, v) in [0, 1)^2
template <class Radius>
Mesh_view tube_torus(double R, int m, int n, Radius radius)
{
  return Conformal_geometry_processing::torus_grid(m, n, 0, [&](int i, int j) {
    const double u = double(i) / m, v = double(j) / n, r = radius(u, v);
    const double distance = R + r * std::cos(2 * pi * v);
    return Eigen::Vector3d(distance * std::cos(2 * pi * u), distance * std::sin(2 * pi * u),
                           r * std::sin(2 * pi * v));
  });
}

/// the torus of revolution
Mesh_view torus(double R, double r, int m, int n);

/// the torus of revolution with every vertex moved along it at random, by up to 0.3 edges each way
Mesh_view irregular_torus(double R, double r, int m, int n);

/// the bumpy torus of the specification, generic: area 4 pi
Mesh_view btorus(int n);

/// a bumpy torus with reflections, hence of rectangular conformal class: area 4 pi
Mesh_view storus(int n);

}  // namespace cgp_test
