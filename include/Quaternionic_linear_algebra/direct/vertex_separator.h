// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

/// \ingroup PkgLinearAlgebra
/// Location of a vertex relative to a vertex separator
enum class Side : char { left, right, separator };

/// \ingroup PkgLinearAlgebra
/// \brief A graph with vertices that must not be on the right (sources) and vertices that must not
/// be on the left (sinks).
struct Terminal_graph {
  std::vector<std::array<int, 2>> edges;
  std::vector<char> is_source, is_sink;  ///< one for each vertex; one vertex may be both

  int size() const { return static_cast<int>(is_source.size()); }
};

/// Computes a maximum set of vertex-disjoint paths from sources to sinks by Dinic's method (1970),
/// without recursion.
///
/// A search for an augmenting path visits a vertex in two states: 2v on entry, 2v + 1 on exit. A
/// vertex on a path cannot be passed from entry to exit; the search may instead follow that path
/// backward and reroute its end.
class Disjoint_paths {
 public:
  explicit Disjoint_paths(const Terminal_graph& graph);

  /// Side of the first cut that separates sources and sinks; vertices reachable by a further path
  /// are left
  Side side(int v) const;

 private:
  enum : int { none = -1, terminal = -2 };

  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  static bool is_exit(int state) { return (state & 1) != 0; }

  bool may_begin(int v) const;

  bool may_end(int v) const { return m_graph.is_sink[at(v)] && m_next[at(v)] != terminal; }

  void find_neighbours();
  int after_entry(int v) const;
  bool find_levels();
  void reach(int state, int level);
  void augment(int root);
  int find_next(int state);
  void update();

  const Terminal_graph& m_graph;
  std::vector<int> m_offsets, m_targets;  // adjacency lists
  std::vector<int> m_next, m_previous;    // on the path through a vertex
  std::vector<int> m_level, m_edge, m_queue, m_path;
};

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Finds a minimum vertex cut between sources and sinks (Menger 1927); if it is not unique,
/// the one nearest to the sources.
///
/// If sources and sinks are the two sides of a bipartite graph, it is a minimum vertex cover
/// (Koenig 1931). O(edges sqrt(vertices)) at worst.
/// \return the side of each vertex. Sources are never right, sinks never left.
std::vector<internal::Side> minimum_vertex_cut(const internal::Terminal_graph& graph);

namespace internal {

/// \ingroup PkgLinearAlgebra
/// \brief A part of a graph with positions, which nested dissection subdivides.
///
/// Stores copies with local indices, so that traversals access memory sequentially even if the
/// vertices of the mesh are badly numbered.
struct Graph_region {
  std::vector<int> vertices;                          ///< their indices in the whole graph
  Eigen::Matrix<float, Eigen::Dynamic, 3> positions;  ///< one row for each vertex
  std::vector<std::array<int, 2>> edges;              ///< between vertices of the region

  int size() const { return static_cast<int>(vertices.size()); }
};

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Returns the whole graph; positions are scaled to [-1, 1], where single precision suffices
/// to choose cuts.
internal::Graph_region graph_region(const Sparse_pattern& pattern,
                                    const Eigen::Matrix3Xd& positions);

/// \ingroup PkgLinearAlgebra
/// \brief Returns the left and the right side.
/// \pre no edge joins left and right
std::array<internal::Graph_region, 2> split(const internal::Graph_region& region,
                                            const std::vector<internal::Side>& sides);

namespace internal {

/// Candidate vertices of a separator, with local indices.
struct Separator_band {
  std::vector<int> vertices, number;  // band to region; region to band, -1 outside
  Terminal_graph graph;

  void add(int v);
};

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Minimizes a separator: from its vertices, and the ends of edges that join left and right
/// directly, selects a minimum set that separates left and right.
///
/// The other vertices keep their sides. The separator is placed near the larger side.
/// O(edges + edges of the separator * sqrt(vertices of the separator)) at worst.
/// \param[in,out] sides one for each vertex; if they contain no separator, it is chosen among the
/// ends of cut edges
void thin_separator(const internal::Graph_region& region, std::vector<internal::Side>& sides);

}  // namespace Conformal_geometry_processing
