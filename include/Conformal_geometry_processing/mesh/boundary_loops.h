// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MESH_BOUNDARY_LOOPS_H
#define CONFORMAL_GEOMETRY_PROCESSING_MESH_BOUNDARY_LOOPS_H

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgMesh
/// \brief Returns the boundary curves of a surface, each as its vertices in order, with the surface
/// on the left.
///
/// A loop starts at its vertex of smallest number; loops are sorted by it. O(|V| + |E|).
/// \pre `require_manifold_edges(mesh)` and `require_manifold_vertices(mesh)` hold: every boundary
/// vertex has one outgoing boundary edge
std::vector<std::vector<int>> boundary_loops(const Mesh_view& mesh);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/mesh/boundary_loops_impl.h>
#endif

#endif
