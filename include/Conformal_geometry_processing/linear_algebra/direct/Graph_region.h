// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_GRAPH_REGION_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_GRAPH_REGION_H

#include <Conformal_geometry_processing/algebra/Sparse_pattern.h>
#include <Conformal_geometry_processing/linear_algebra/direct/minimum_vertex_cut.h>

#include <Eigen/Core>

#include <array>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief a part of a graph with positions, that nested dissection takes apart.
///
/// Holds copies, in numbers of its own, of all it needs: a list of edges is swept without jumps
/// through memory, however badly the mesh is numbered.
struct Graph_region {
  using Pairs = std::vector<std::array<int, 2>>;

  std::vector<int> vertices;                          ///< their numbers in the whole graph
  Eigen::Matrix<float, Eigen::Dynamic, 3> positions;  ///< one row for each vertex
  Pairs edges;                                        ///< between vertices of the region
  Pairs halo;  ///< edges (vertex of the region, number of a separator vertex in the whole graph)

  int size() const { return static_cast<int>(vertices.size()); }
};

/// \relates Graph_region
/// \brief the whole graph; positions are scaled to [-1, 1], where single precision suffices to
/// choose cuts.
Graph_region graph_region(const Sparse_pattern& pattern, const Eigen::Matrix3Xd& positions);

/// \relates Graph_region
/// \brief the vertices of the left and of the right side, with the separator in their halo.
/// \pre no edge joins left and right
std::array<Graph_region, 2> split(const Graph_region& region, const std::vector<Side>& sides);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/linear_algebra/direct/Graph_region_impl.h>
#endif

#endif
