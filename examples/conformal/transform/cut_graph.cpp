// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "cut_graph.h"

#include "conformal/process/at.h"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace conformal {
namespace {

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
    const int h = *mesh.halfedges_begin(k), t = mesh.twin(h);
    const int f = joined.find_set(CGP::Mesh_view::face(h));
    const int g = t < 0 ? f : joined.find_set(CGP::Mesh_view::face(t));
    if (f == g)
      left.push_back(k);
    else
      joined.link(f, g);
  }
  return left;
}

/// where all paths end
int root(const CGP::Mesh_view& mesh, const std::vector<int>& tips)
{
  for (int h = 0; h < mesh.size_of_halfedges(); ++h)
    if (mesh.twin(h) < 0) return mesh.from(h);
  return tips.front();
}

}  // namespace

std::vector<int> find_tips(const CGP::Mesh_view& mesh, int count, const Edge_set& ways)
{
  // The first vertex is anywhere; the one farthest from it is at a tip.
  Shortest_paths from_anywhere(mesh, ways), from_tips(mesh, ways);
  from_anywhere.add_root(0);
  std::vector<int> found = {from_anywhere.farthest_vertex()};
  from_tips.add_root(found.back());
  while (static_cast<int>(found.size()) < (std::min)(count, mesh.size_of_vertices())) {
    found.push_back(from_tips.farthest_vertex());
    from_tips.add_root(found.back());
  }
  return found;
}

Edge_set cut_graph(const CGP::Mesh_view& mesh, const std::vector<int>& tips, const Edge_set& ways)
{
  Shortest_paths tree(mesh, ways);
  tree.add_root(root(mesh, tips));
  Edge_set cut(at(mesh.size_of_edges()), 0);
  for (const int v : tips) tree.add_path(v, cut);
  for (const int k : without_cotree(mesh, by_loop_length(mesh, tree, ways))) {
    cut[at(k)] = 1;
    for (const int v : mesh.ends(k)) tree.add_path(v, cut);
  }
  return cut;
}

}  // namespace conformal
