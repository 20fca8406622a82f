// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "support/mesh_tools.h"

/// Good meshes spoilt: the same surface in faces as thin as one likes.
namespace cgp_test {

/// \brief the mesh with a new vertex in every third face, near the edge from its first corner to
/// the second; the vertices of the mesh come first.
/// \param height above the edge, relative to its length: of a cap; zero makes a face of area zero
/// \param where along the edge, from 0 (the first corner: a needle) to 1
/// \param fold how much of the height is along the normal, too
Mesh_view with_thin_faces(const Mesh_view& mesh, double height, double where = .5, double fold = 0);

/// caps, needles and faces of area zero together, and folded ones
Mesh_view spoilt(const Mesh_view& mesh);

}  // namespace cgp_test
