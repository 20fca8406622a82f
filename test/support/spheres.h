// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cmath>
#include <utility>

#include "support/mesh_tools.h"

/// Spheres around the origin, and the curvature potential that the specification uses on them.
namespace cgp_test {

/// corners (+-1, +-phi, 0) and cyclic, divided by their length
Mesh_view icosahedron();

Mesh_view projected_to_sphere(const Mesh_view& mesh);

/// the unit sphere with 20 * 4^level faces: 4-1 subdivision, projected after each level
Mesh_view icosphere(int level);

/// the unit sphere with 20 frequency^2 faces: edges of the icosahedron split evenly, then projected
Mesh_view geodesic_sphere(int frequency);

/// r = 1 + amplitude (xy + z (5z^2 - 3) / 4 + 0.4 (x^2 - y^2) z) over the unit sphere
Mesh_view bumpy_sphere(int level, double amplitude = 0.25);

/// rho = 1.5 xy + 0.8 z (5z^2 - 3) / 2 + 0.7 (x^2 - y^2) z + 0.5 xyz at the normalised point
double rho_of_section_3(const Eigen::Vector3d& point);

Eigen::VectorXd rho_of_section_3_on_vertices(const Mesh_view& mesh);

/// at the normalised centroids
Eigen::VectorXd rho_of_section_3_on_faces(const Mesh_view& mesh);

}  // namespace cgp_test
