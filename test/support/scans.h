// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "support/random.h"

/// Meshes as scanners make them: vertices of any degree, triangles of many sizes and shapes, noise.
namespace cgp_test {

/// n random points of the unit sphere, none nearer to another than a third of their mean spacing
Points scattered_points(int n, std::uint64_t seed);

/// the convex hull of points of which none is inside, one after the other
Corners convex_hull(const Points& p);

/// a body with four limbs, in n random points joined as the Delaunay triangulation of the sphere
/// joins them; the noise is up to `noise` times the radius
Mesh_view scan(int n, double noise = 0.01, std::uint64_t seed = 1);

}  // namespace cgp_test
