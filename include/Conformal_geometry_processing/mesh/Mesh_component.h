// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <vector>

namespace Conformal_geometry_processing {

namespace internal {

/// \ingroup PkgMesh
/// \brief A part of a mesh, such as a connected component, as a separate mesh.
///
/// Vertices and faces keep their order, so results are bitwise the same as for the part alone.
/// Matrices of the whole mesh are block diagonal with one block per component, so factorizations
/// and eigenvectors of the blocks can be computed for each component.
struct Mesh_component {
  Mesh_view mesh;
  std::vector<int> vertices, faces;  ///< their indices in the whole mesh, ascending
};

}  // namespace internal

/// \ingroup PkgMesh
/// Returns the components in the order of their first vertices; an isolated vertex is a component,
/// too. O(|V| + |E| + |F|)
std::vector<internal::Mesh_component> mesh_components(const Mesh_view& mesh);

namespace internal {

/// \ingroup PkgMesh
/// Returns the faces with a nonzero entry, and their vertices. O(|V| + |F|)
/// \param is_selected |F|
Mesh_component selected_faces(const Mesh_view& mesh, const std::vector<char>& is_selected);

}  // namespace internal

}  // namespace Conformal_geometry_processing
