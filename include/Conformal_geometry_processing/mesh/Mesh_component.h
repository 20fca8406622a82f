// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MESH_MESH_COMPONENT_H
#define CONFORMAL_GEOMETRY_PROCESSING_MESH_MESH_COMPONENT_H

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgMesh
/// \brief a connected component of a mesh as a mesh of its own.
///
/// Vertices and faces keep their order, so that it is to the bit what it would be alone. A matrix
/// of the whole mesh is block diagonal, with a block for each component: to factor it, or to find
/// an eigenvector of each block, is to do so for each component.
struct Mesh_component {
  Mesh_view mesh;
  std::vector<int> vertices, faces;  ///< what are their numbers in the whole mesh; ascending
};

/// \ingroup PkgMesh
/// the components in the order of their first vertices; a vertex without faces is one, too.
/// O(|V| + |E| + |F|)
std::vector<Mesh_component> mesh_components(const Mesh_view& mesh);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/mesh/Mesh_component_impl.h>
#endif

#endif
