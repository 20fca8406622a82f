// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "support/bounded_meshes.h"
#include "support/mesh_tools.h"

/// Closed surfaces with flat sides.
namespace cgp_test {

/// the regular one with edges 2 sqrt(2), in the cube [-1, 1]^3
Mesh_view tetrahedron();

/// the surface of a union of unit cubes [i, i+1] x [j, j+1] x [k, k+1], each square in two
/// triangles with alternating diagonals. A manifold if no two cubes touch in an edge or corner
/// only.
Mesh_view surface_of_cubes(const std::set<std::array<int, 3>>& cubes);

/// the surface of an nx x ny x nz block of unit cubes
Mesh_view block(int nx, int ny, int nz);

Mesh_view cube();

/// a 5 x 3 x 1 block with two square holes
Mesh_view double_torus();

}  // namespace cgp_test
