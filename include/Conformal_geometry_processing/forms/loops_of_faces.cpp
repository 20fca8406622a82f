// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/forms/loops_of_faces.h>

#include <Conformal_geometry_processing/forms/tree_cotree.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {

std::vector<internal::Face_loop> loops_of_faces(const Mesh_view& mesh)
{
  const internal::Tree_cotree trees(mesh);
  std::vector<internal::Face_loop> loops;
  for (const int k : trees.leftover_edges()) {
    // The path through the edge to the root of the tree, and the path to the root from the face
    // before.
    internal::Face_loop there, back;
    trees.for_each_crossing(
        k, [&](int h, int sign) { sign > 0 ? there.push_back(h) : back.push_back(h); });
    for (; !there.empty() && !back.empty() && there.back() == back.back(); there.pop_back())
      back.pop_back();
    std::reverse(back.begin(), back.end());
    for (const int h : back) there.push_back(mesh.twin(h));
    loops.push_back(std::move(there));
  }
  return loops;
}

Eigen::MatrixXi crossings_modulo_2(const Mesh_view& mesh,
                                   const std::vector<internal::Face_loop>& loops)
{
  const auto n = static_cast<Eigen::Index>(loops.size());
  Eigen::MatrixXi crossings = Eigen::MatrixXi::Zero(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    std::vector<char> is_crossed(static_cast<std::size_t>(mesh.size_of_edges()), 0);
    for (const int h : loops[static_cast<std::size_t>(j)])
      is_crossed[static_cast<std::size_t>(mesh.edge(h))] = 1;
    for (Eigen::Index i = 0; i < n; ++i) {
      // Shifted to its left, the loop runs along the edges of its faces on that side.
      const internal::Face_loop& loop = loops[static_cast<std::size_t>(i)];
      for (std::size_t k = 0; k < loop.size(); ++k) {
        const int in = mesh.twin(loop[k]), out = loop[(k + 1) % loop.size()];
        if (Mesh_view::next_in_face(in) == out)
          crossings(i, j) ^=
              is_crossed[static_cast<std::size_t>(mesh.edge(Mesh_view::previous_in_face(in)))];
      }
    }
  }
  return crossings;
}

}  // namespace Conformal_geometry_processing
