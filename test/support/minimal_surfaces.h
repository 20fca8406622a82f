// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Boundary_frames.h>

#include <array>
#include <complex>

#include "support/bounded_meshes.h"

/// Minimal surfaces in closed form, by Weierstrass' representation: conformal images of plane
/// domains.
namespace cgp_test {

/// Enneper's surface X = Re(z - c^2 z^3/3, -i(z + c^2 z^3/3), c z^2) over a plane mesh
Mesh_view enneper(const Mesh_view& plane, double c = 0.8);

/// dX(v) for a vector v at the point p of the plane
Eigen::Vector3d enneper_differential(const Eigen::Vector3d& p, const Eigen::Vector3d& v,
                                     double c = 0.8);

/// the tangents of the boundary of Enneper's surface over a plane mesh, in the order of
/// `boundary_frames()`
Points enneper_tangents(const Mesh_view& plane, double c = 0.8);

/// a strip of the catenoid (cosh u cos v, cosh u sin v, u), |u| <= 1, 0 <= v <= 4
Mesh_view catenoid_strip(int n);

/// the same strip of the helicoid (-sinh u sin v, sinh u cos v, -v), to which it is isometric
Mesh_view helicoid_strip(int n);

}  // namespace cgp_test
