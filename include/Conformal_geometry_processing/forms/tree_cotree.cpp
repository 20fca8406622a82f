// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/forms/tree_cotree.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

Tree_cotree::Tree_cotree(const Mesh_view& mesh) : m_mesh(mesh)
{
  grow_cotree();
  grow_tree();
}

int Tree_cotree::beyond(int h) const
{
  const int g = m_mesh.twin(h);
  return g < 0 ? outside() : Mesh_view::face(g);
}

void Tree_cotree::grow_cotree()
{
  m_exit.assign(at(m_mesh.size_of_faces() + 1), -1);
  m_is_crossed.assign(at(m_mesh.size_of_edges()), 0);
  std::vector<char> is_met(m_exit.size(), 0);
  std::vector<int> queue = {0};
  is_met[0] = 1;
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const int here = queue[i];
    for_each_halfedge_around(here, [&](int h) {
      const int f = here == outside() ? Mesh_view::face(h) : beyond(h);
      if (is_met[at(f)]) return;
      is_met[at(f)] = 1;
      m_exit[at(f)] = m_mesh.twin(h) < 0 ? h : m_mesh.twin(h);
      m_is_crossed[at(m_mesh.edge(h))] = 1;
      queue.push_back(f);
    });
  }
}

void Tree_cotree::grow_tree()
{
  std::vector<int> root(at(m_mesh.size_of_vertices()));
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](int v) {
    while (root[at(v)] != v) v = root[at(v)] = root[at(root[at(v)])];
    return v;
  };
  for (int k = 0; k < m_mesh.size_of_edges(); ++k) {
    if (m_is_crossed[at(k)]) continue;
    const int a = find(m_mesh.ends(k)[0]), b = find(m_mesh.ends(k)[1]);
    if (a == b)
      m_leftover.push_back(k);
    else
      root[at(b)] = a;
  }
}

}  // namespace internal

Eigen::MatrixXd closed_generators(const Mesh_view& mesh)
{
  const internal::Tree_cotree trees(mesh);
  const auto count = static_cast<Eigen::Index>(trees.leftover_edges().size());
  Eigen::MatrixXd forms = Eigen::MatrixXd::Zero(mesh.size_of_edges(), count);
  for (Eigen::Index i = 0; i < count; ++i)
    trees.for_each_crossing(trees.leftover_edges()[static_cast<std::size_t>(i)],
                            [&](int h, int sign) {
                              forms(mesh.edge(h), i) += mesh.from(h) < mesh.to(h) ? sign : -sign;
                            });
  return forms;
}

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
