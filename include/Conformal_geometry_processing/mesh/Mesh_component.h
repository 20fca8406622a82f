// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MESH_MESH_COMPONENT_H
#define CONFORMAL_GEOMETRY_PROCESSING_MESH_MESH_COMPONENT_H

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/topology.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
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
inline std::vector<Mesh_component> mesh_components(const Mesh_view& mesh)
{
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  const std::vector<int> component = connected_components(mesh);
  int count = 0;
  for (const int c : component) count = (std::max)(count, c + 1);
  std::vector<Mesh_component> parts(at(count));
  std::vector<Mesh_view::Corners> corners(at(count));
  std::vector<int> number(component.size());  // in its component
  for (int v = 0; v < mesh.size_of_vertices(); ++v) {
    std::vector<int>& vertices = parts[at(component[at(v)])].vertices;
    number[at(v)] = static_cast<int>(vertices.size());
    vertices.push_back(v);
  }
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const std::array<int, 3>& v = mesh.corners(f);
    const std::size_t c = at(component[at(v[0])]);
    parts[c].faces.push_back(f);
    corners[c].push_back({number[at(v[0])], number[at(v[1])], number[at(v[2])]});
  }
  for (std::size_t c = 0; c < parts.size(); ++c)
    parts[c].mesh =
        Mesh_view(mesh.positions()(Eigen::all, parts[c].vertices), std::move(corners[c]));
  return parts;
}

}  // namespace Conformal_geometry_processing

#endif
