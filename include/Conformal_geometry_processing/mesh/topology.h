// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MESH_TOPOLOGY_H
#define CONFORMAL_GEOMETRY_PROCESSING_MESH_TOPOLOGY_H

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/boundary_loops.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgMesh
/// the connected component of each vertex, numbered from 0 in the order of their first vertices;
/// a vertex without faces is a component of its own. O(|V| + |E|)
inline std::vector<int> connected_components(const Mesh_view& mesh)
{
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  std::vector<int> root(at(mesh.size_of_vertices()));
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](int v) {
    while (root[at(v)] != v) v = root[at(v)] = root[at(root[at(v)])];
    return v;
  };
  for (int k = 0; k < mesh.size_of_edges(); ++k) {
    const int a = find(mesh.ends(k)[0]), b = find(mesh.ends(k)[1]);
    root[at((std::max)(a, b))] = (std::min)(a, b);  // the smallest vertex is the root
  }
  std::vector<int> component(root.size());
  int count = 0;
  for (int v = 0; v < mesh.size_of_vertices(); ++v)
    component[at(v)] = find(v) == v ? count++ : component[at(find(v))];
  return component;
}

/// \ingroup PkgMesh
/// \brief the numbers that classify a surface up to homeomorphism.
struct Topology {
  int vertices = 0, edges = 0, faces = 0;
  int components = 0;
  int boundary_loops = 0;
  int genus = 0;  ///< number of handles, summed over the components

  /// V - E + F = 2 components - 2 genus - loops
  int euler_characteristic() const { return vertices - edges + faces; }
  bool is_closed() const { return boundary_loops == 0; }
  bool is_sphere() const { return components == 1 && genus == 0 && is_closed(); }
  bool is_disk() const { return components == 1 && genus == 0 && boundary_loops == 1; }
};

/// \ingroup PkgMesh
/// the topology of an oriented manifold mesh
/// \pre `require_manifold_edges(mesh)` and `require_manifold_vertices(mesh)` hold, and no vertex is
/// without a face
inline Topology topology(const Mesh_view& mesh)
{
  Topology t;
  t.vertices = mesh.size_of_vertices();
  t.edges = mesh.size_of_edges();
  t.faces = mesh.size_of_faces();
  for (int c : connected_components(mesh)) t.components = (std::max)(t.components, c + 1);
  t.boundary_loops = static_cast<int>(boundary_loops(mesh).size());
  t.genus = (2 * t.components - t.boundary_loops - t.euler_characteristic()) / 2;
  return t;
}

}  // namespace Conformal_geometry_processing

#endif
