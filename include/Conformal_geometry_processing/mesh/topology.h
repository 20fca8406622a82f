// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgMesh
/// Returns the connected component of each vertex, numbered from 0 in the order of their first
/// vertices; an isolated vertex is a component of its own. O(|V| + |E|)
std::vector<int> connected_components(const Mesh_view& mesh);

namespace internal {

/// \brief Topological invariants that classify a surface up to homeomorphism.
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

}  // namespace internal

/// \ingroup PkgMesh
/// Computes the topology of an oriented manifold mesh
/// \pre `require_manifold_edges(mesh)` and `require_manifold_vertices(mesh)` hold, and no vertex is
/// isolated
internal::Topology topology(const Mesh_view& mesh);

/// \ingroup PkgMesh
/// \brief Returns the boundary curves of a surface, each as its vertices in order, with the surface
/// on the left.
///
/// A loop starts at its vertex of smallest number; loops are sorted by it. O(|V| + |E|).
/// \pre `require_manifold_edges(mesh)` and `require_manifold_vertices(mesh)` hold: every boundary
/// vertex has one outgoing boundary edge
std::vector<std::vector<int>> boundary_loops(const Mesh_view& mesh);

}  // namespace Conformal_geometry_processing
