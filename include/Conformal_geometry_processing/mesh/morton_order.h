// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_component.h>

namespace Conformal_geometry_processing::internal {

/// \brief the part with its vertices along the Morton curve of their positions, and its faces
/// sorted by their corners, the least of which is the first: what is near on the surface is near in
/// memory.
///
/// The order is that of the shape, so a mesh whose elements are numbered in another way becomes the
/// same mesh, bit by bit; but vertices at the same position whose neighbours are at the same
/// positions, too, keep their order. O(|V| log |V|)
/// \pre positions are finite
Mesh_component in_morton_order(const Mesh_component& part);

}  // namespace Conformal_geometry_processing::internal
