// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_VERTEX_GRAPH_H
#define CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_VERTEX_GRAPH_H

#include <Conformal_geometry_processing/algebra/Sparse_pattern.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <cstddef>
#include <memory>

namespace Conformal_geometry_processing {

/// \ingroup PkgOperators
/// \brief the pattern of every Hermitian matrix on the vertices of a mesh: |V| diagonal entries
/// and one for each edge.
///
/// Edges are sorted by their ends (i, j), i < j, and column i holds (i, i) before its edges, so the
/// entry (j, i) of edge k has position k + i + 1 and assembly needs no table.
inline std::shared_ptr<const Sparse_pattern> vertex_graph(const Mesh_view& mesh)
{
  auto pattern = std::make_shared<Sparse_pattern>();
  const int n = mesh.size_of_vertices();
  pattern->offsets.reserve(static_cast<std::size_t>(n) + 1);
  pattern->indices.reserve(static_cast<std::size_t>(n) +
                           static_cast<std::size_t>(mesh.size_of_edges()));
  for (int i = 0, k = 0; i < n; ++i) {
    pattern->offsets.push_back(static_cast<int>(pattern->indices.size()));
    pattern->indices.push_back(i);
    for (; k < mesh.size_of_edges() && mesh.ends(k)[0] == i; ++k)
      pattern->indices.push_back(mesh.ends(k)[1]);
  }
  pattern->offsets.push_back(static_cast<int>(pattern->indices.size()));
  return pattern;
}

/// the position of the diagonal entry (i, i) in `vertex_graph(mesh)`
inline int diagonal_position(const Sparse_pattern& pattern, int i)
{
  return pattern.offsets[static_cast<std::size_t>(i)];
}

/// the position of the entry (j, i), i < j, of edge k in `vertex_graph(mesh)`
inline int edge_position(const Mesh_view& mesh, int k)
{
  return k + mesh.ends(k)[0] + 1;
}

}  // namespace Conformal_geometry_processing

#endif
