// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/forms/tree_cotree.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace Conformal_geometry_processing {
namespace internal {

/// A spanning tree of the faces by breadth-first search, which keeps the loops short, and the
/// leftover edges: those neither crossed by it nor contained in a spanning tree of the vertices.
/// The outside of a surface with boundary counts as one more face, so 2G + loops - 1 edges are left
/// over, and 2G without boundary.
class Tree_cotree {
 public:
  explicit Tree_cotree(const Mesh_view& mesh) : m_mesh(mesh)
  {
    grow_cotree();
    grow_tree();
  }

  /// the leftover edges, ascending
  const std::vector<int>& leftover_edges() const { return m_leftover; }

  /// the halfedges of the loop of faces that crosses the leftover edge k: calls visit(h, sign) with
  /// sign = 1 where the loop leaves face(h) through h, and with sign = -1 where it enters there.
  /// Edges traversed twice are reported with both signs.
  template <class Visitor>
  void for_each_crossing(int k, Visitor visit) const
  {
    const int h = *m_mesh.halfedges_begin(k);
    visit(h, 1);
    walk_to_root(beyond(h), 1, visit);
    walk_to_root(Mesh_view::face(h), -1, visit);
  }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  template <class Visitor>
  void walk_to_root(int f, int sign, Visitor visit) const
  {
    for (int h = m_exit[at(f)]; h >= 0; h = m_exit[at(f)]) {
      const bool is_outside = f == outside();
      visit(h, is_outside ? -sign : sign);
      f = is_outside ? Mesh_view::face(h) : beyond(h);
    }
  }

  int outside() const { return m_mesh.size_of_faces(); }

  /// the face on the other side of a halfedge
  int beyond(int h) const
  {
    const int g = m_mesh.twin(h);
    return g < 0 ? outside() : Mesh_view::face(g);
  }

  /// the halfedges through which the neighbouring faces reach f
  template <class Visitor>
  void for_each_halfedge_around(int f, Visitor visit) const
  {
    if (f < outside())
      for (int h = 3 * f; h < 3 * f + 3; ++h) visit(h);
    else
      for (int h = 0; h < m_mesh.size_of_halfedges(); ++h)
        if (m_mesh.twin(h) < 0) visit(h);
  }

  void grow_cotree()
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

  void grow_tree()
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

  const Mesh_view& m_mesh;
  // |F| + 1 entries, the last for the outside: the halfedge towards the root, -1 at the root.
  // Boundary edges have one halfedge for both directions.
  std::vector<int> m_exit;
  std::vector<char> m_is_crossed;  // |E|: by the tree of the faces
  std::vector<int> m_leftover;
};

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
