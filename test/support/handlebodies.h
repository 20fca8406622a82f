// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <array>
#include <set>
#include <utility>

#include "support/mesh_tools.h"
#include "support/polyhedra.h"

/// Closed surfaces of any genus.
namespace cgp_test {

/// the surface of a block of unit cubes with `genus` square holes in a row. Its diagonals have
/// cotan weight zero.
Mesh_view holed_block(int genus);

/// each vertex moves to the mean of itself and its neighbours, all at once, several times
Mesh_view smoothed(const Mesh_view& mesh, int times);

/// a rounded body with `genus` holes, of area 4 pi: 4^level times the faces of `holed_block()`
Mesh_view smooth_handlebody(int genus, int level);

}  // namespace cgp_test
