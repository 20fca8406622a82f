// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MESH_BOUNDARY_LOOPS_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_MESH_BOUNDARY_LOOPS_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/mesh/boundary_loops.h>

#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing {

CGP_INLINE std::vector<std::vector<int>> boundary_loops(const Mesh_view& mesh)
{
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  std::vector<int> successor(at(mesh.size_of_vertices()), -1);
  for (int h = 0; h < mesh.size_of_halfedges(); ++h)
    if (mesh.twin(h) < 0) successor[at(mesh.from(h))] = mesh.to(h);
  std::vector<std::vector<int>> loops;
  for (int v = 0; v < mesh.size_of_vertices(); ++v) {
    if (successor[at(v)] < 0) continue;
    loops.emplace_back();
    for (int i = v; successor[at(i)] >= 0;) {
      loops.back().push_back(i);
      const int next = successor[at(i)];
      successor[at(i)] = -1;
      i = next;
    }
  }
  return loops;
}

}  // namespace Conformal_geometry_processing

#endif
