// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

/// Location of a vertex relative to a vertex separator
enum class Side : char { left, right, separator };

/// \brief A graph with vertices that must not be on the right (sources) and vertices that must not
/// be on the left (sinks).
struct Terminal_graph {
  std::vector<std::array<int, 2>> edges;
  std::vector<char> is_source, is_sink;  ///< one for each vertex; one vertex may be both

  int size() const { return static_cast<int>(is_source.size()); }
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
