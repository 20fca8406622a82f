// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "cut_graph.h"

#include "conformal/process/at.h"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>
#include <utility>

namespace conformal {
namespace {

double length(const CGP::Mesh_view& mesh, int k)
{
  return mesh.vector(*mesh.halfedges_begin(k)).norm();
}

/// Shortest paths along edges from all vertices to the nearest root
class Shortest_paths {
 public:
  Shortest_paths(const CGP::Mesh_view& mesh, const std::vector<int>& roots, const Edge_set& ways)
      : m_mesh(mesh),
        m_distance(at(mesh.size_of_vertices()), HUGE_VAL),
        m_first_edge(m_distance.size(), -1)
  {
    std::vector<std::vector<int>> edges(m_distance.size());
    for (int k = 0; k < mesh.size_of_edges(); ++k)
      if (ways[at(k)])
        for (const int v : mesh.ends(k)) edges[at(v)].push_back(k);
    for (const int v : roots) reach(v, 0, -1);
    while (!m_queue.empty()) {
      const auto [distance, v] = m_queue.top();
      m_queue.pop();
      if (-distance > m_distance[at(v)]) continue;
      for (const int k : edges[at(v)]) reach(other_end(k, v), length(mesh, k) - distance, k);
    }
  }

  double distance(int v) const { return m_distance[at(v)]; }
  bool has(int k) const
  {
    const auto& ends = m_mesh.ends(k);
    return m_first_edge[at(ends[0])] == k || m_first_edge[at(ends[1])] == k;
  }

  int farthest_vertex() const
  {
    return static_cast<int>(std::max_element(m_distance.begin(), m_distance.end()) -
                            m_distance.begin());
  }

  /// Adds the edges from v to its root, up to those that are there.
  void add_path(int v, Edge_set& edges) const
  {
    for (int k = m_first_edge[at(v)]; k >= 0 && !edges[at(k)]; k = m_first_edge[at(v)]) {
      edges[at(k)] = 1;
      v = other_end(k, v);
    }
  }

 private:
  int other_end(int k, int v) const
  {
    const auto& ends = m_mesh.ends(k);
    return ends[0] == v ? ends[1] : ends[0];
  }

  void reach(int v, double distance, int by)
  {
    if (distance >= m_distance[at(v)]) return;
    m_distance[at(v)] = distance;
    m_first_edge[at(v)] = by;
    m_queue.emplace(-distance, v);
  }

  const CGP::Mesh_view& m_mesh;
  std::vector<double> m_distance;
  std::vector<int> m_first_edge;                        // of the path to the root, -1 at a root
  std::priority_queue<std::pair<double, int>> m_queue;  // nearest first: minus the distance
};

/// The edges outside the tree, those that make the longest loops with it first; edges that are no
/// ways make endless ones.
std::vector<int> by_loop_length(const CGP::Mesh_view& mesh, const Shortest_paths& tree,
                                const Edge_set& ways)
{
  std::vector<std::pair<double, int>> loops;
  for (int k = 0; k < mesh.size_of_edges(); ++k) {
    if (tree.has(k)) continue;
    const auto& ends = mesh.ends(k);
    const double loop = tree.distance(ends[0]) + tree.distance(ends[1]) + length(mesh, k);
    loops.emplace_back(ways[at(k)] ? -loop : -HUGE_VAL, k);
  }
  std::sort(loops.begin(), loops.end());
  std::vector<int> edges;
  for (const auto& [loop, k] : loops) edges.push_back(k);
  return edges;
}

/// What is left of these edges once the faces are joined across them, if they are not yet.
std::vector<int> without_cotree(const CGP::Mesh_view& mesh, const std::vector<int>& edges)
{
  std::vector<int> parent(at(mesh.size_of_faces())), rank(parent.size(), 0), left;
  std::iota(parent.begin(), parent.end(), 0);
  boost::disjoint_sets<int*, int*> joined(rank.data(), parent.data());
  for (const int k : edges) {
    const int h = *mesh.halfedges_begin(k);
    const int f = joined.find_set(CGP::Mesh_view::face(h));
    const int g = joined.find_set(CGP::Mesh_view::face(mesh.twin(h)));
    if (f == g)
      left.push_back(k);
    else
      joined.link(f, g);
  }
  return left;
}

}  // namespace

std::vector<int> find_tips(const CGP::Mesh_view& mesh, int count, const Edge_set& ways)
{
  // The first vertex is anywhere; the one farthest from it is at a tip.
  std::vector<int> found = {Shortest_paths(mesh, {0}, ways).farthest_vertex()};
  while (static_cast<int>(found.size()) < count)
    found.push_back(Shortest_paths(mesh, found, ways).farthest_vertex());
  return found;
}

Edge_set cut_graph(const CGP::Mesh_view& mesh, const std::vector<int>& tips, const Edge_set& ways)
{
  const Shortest_paths tree(mesh, {tips.front()}, ways);
  Edge_set cut(at(mesh.size_of_edges()), 0);
  for (const int v : tips) tree.add_path(v, cut);
  for (const int k : without_cotree(mesh, by_loop_length(mesh, tree, ways))) {
    cut[at(k)] = 1;
    for (const int v : mesh.ends(k)) tree.add_path(v, cut);
  }
  return cut;
}

}  // namespace conformal
