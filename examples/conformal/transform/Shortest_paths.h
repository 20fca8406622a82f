// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <queue>
#include <utility>
#include <vector>

namespace conformal {

namespace CGP = Conformal_geometry_processing;

/// Which edges of a mesh, by their numbers
using Edge_set = std::vector<char>;

/// of a cut along edge k: nothing at the boundary
double length(const CGP::Mesh_view& mesh, int k);

/// \brief Shortest paths along edges from all vertices to the nearest root [Dijkstra 1959].
///
/// Another root costs no more than the vertices that are nearer to it than to those before.
class Shortest_paths {
 public:
  /// \param mesh is referred to
  /// \param ways the edges of which the paths may consist
  Shortest_paths(const CGP::Mesh_view& mesh, const Edge_set& ways);

  void add_root(int v);

  /// endless without a root that can be reached
  double distance(int v) const;

  /// whether a path begins with edge k
  bool has(int k) const;

  /// The vertex with the longest path, the first of several
  /// \pre there is a root
  int farthest_vertex();

  /// Adds the edges from v to its root, up to those that are there.
  void add_path(int v, Edge_set& edges) const;

  /// How many vertices have got a shorter path, one after another, since the first root
  long size_of_steps() const { return m_steps; }

 private:
  using Farthest_first = std::priority_queue<std::pair<double, int>>;

  int other_end(int k, int v) const;
  /// a vertex, and with it all of its boundary loop, which no other path reaches then
  void reach(int first, double distance, int by);

  const CGP::Mesh_view& m_mesh;
  std::vector<std::vector<int>> m_edges;  // at each vertex
  std::vector<double> m_distance;
  std::vector<int> m_first_edge;  // of the path to the root, -1 at a root
  Farthest_first m_nearest;       // to be continued from: minus the distance
  Farthest_first m_farthest;      // and minus the vertex; distances that have shrunk are there too
  long m_steps = 0;
};

}  // namespace conformal
