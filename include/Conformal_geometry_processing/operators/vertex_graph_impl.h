// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_VERTEX_GRAPH_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_VERTEX_GRAPH_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>

#include <cstddef>
#include <memory>

namespace Conformal_geometry_processing {

CGP_INLINE std::shared_ptr<const Sparse_pattern> vertex_graph(const Mesh_view& mesh)
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

CGP_INLINE int diagonal_position(const Sparse_pattern& pattern, int i)
{
  return pattern.offsets[static_cast<std::size_t>(i)];
}

CGP_INLINE int edge_position(const Mesh_view& mesh, int k)
{
  return k + mesh.ends(k)[0] + 1;
}

}  // namespace Conformal_geometry_processing

#endif
