// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/topology.h>

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace Conformal_geometry_processing {

std::vector<int> connected_components(const Mesh_view& mesh)
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

internal::Topology topology(const Mesh_view& mesh)
{
  internal::Topology t;
  t.vertices = mesh.size_of_vertices();
  t.edges = mesh.size_of_edges();
  t.faces = mesh.size_of_faces();
  for (int c : connected_components(mesh)) t.components = (std::max)(t.components, c + 1);
  t.boundary_loops = static_cast<int>(boundary_loops(mesh).size());
  t.genus = (2 * t.components - t.boundary_loops - t.euler_characteristic()) / 2;
  return t;
}

std::vector<std::vector<int>> boundary_loops(const Mesh_view& mesh)
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
