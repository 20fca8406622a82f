// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_GRAPH_REGION_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_GRAPH_REGION_H

#include <Conformal_geometry_processing/algebra/Sparse_pattern.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief a part of a graph with positions, that nested dissection takes apart.
///
/// Holds copies, in numbers of its own, of all it needs: a list of edges is swept without jumps
/// through memory, however badly the mesh is numbered.
struct Graph_region {
  enum Side : char { left, right, separator };
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
inline Graph_region graph_region(const Sparse_pattern& pattern, const Eigen::Matrix3Xd& positions)
{
  Graph_region region;
  const int n = pattern.size();
  region.vertices.resize(static_cast<std::size_t>(n));
  std::iota(region.vertices.begin(), region.vertices.end(), 0);
  region.edges.reserve(pattern.indices.size() - region.vertices.size());
  for (int j = 0; j < n; ++j)
    for (int k = pattern.offsets[static_cast<std::size_t>(j)] + 1;
         k < pattern.offsets[static_cast<std::size_t>(j) + 1]; ++k)
      region.edges.push_back({j, pattern.indices[static_cast<std::size_t>(k)]});
  if (n == 0) return region;
  const Eigen::Vector3d low = positions.rowwise().minCoeff(), high = positions.rowwise().maxCoeff();
  const Eigen::Vector3d center = low / 2 + high / 2;  // halves: the sum may overflow
  const double radius = (high / 2 - low / 2).maxCoeff();
  region.positions.resize(n, 3);
  for (int a = 0; a < 3; ++a)
    if (radius > 0)
      region.positions.col(a) =
          ((positions.row(a).transpose().array() - center[a]) / radius).cast<float>();
    else
      region.positions.col(a).setZero();
  return region;
}

/// \relates Graph_region
/// \brief the vertices of the left and of the right side, with the separator in their halo.
/// \pre no edge joins left and right
inline std::array<Graph_region, 2> split(const Graph_region& region, const std::vector<char>& side)
{
  std::array<Graph_region, 2> parts;
  std::vector<int> place(region.vertices.size());
  for (std::size_t v = 0; v < place.size(); ++v)
    if (side[v] != Graph_region::separator) {
      auto& vertices = parts[static_cast<std::size_t>(side[v])].vertices;
      place[v] = static_cast<int>(vertices.size());
      vertices.push_back(region.vertices[v]);
    }
  for (Graph_region& part : parts) part.positions.resize(part.size(), 3);
  for (std::size_t v = 0; v < place.size(); ++v)
    if (side[v] != Graph_region::separator)
      parts[static_cast<std::size_t>(side[v])].positions.row(place[v]) =
          region.positions.row(static_cast<Eigen::Index>(v));
  const auto add_to_halo = [&](int inner, int outer) {
    const auto v = static_cast<std::size_t>(inner);
    parts[static_cast<std::size_t>(side[v])].halo.push_back({place[v], outer});
  };
  for (const auto& e : region.edges) {
    const auto a = static_cast<std::size_t>(e[0]), b = static_cast<std::size_t>(e[1]);
    if (side[a] != Graph_region::separator && side[b] != Graph_region::separator)
      parts[static_cast<std::size_t>(side[a])].edges.push_back({place[a], place[b]});
    else if (side[a] != Graph_region::separator)
      add_to_halo(e[0], region.vertices[b]);
    else if (side[b] != Graph_region::separator)
      add_to_halo(e[1], region.vertices[a]);
  }
  for (const auto& e : region.halo)
    if (side[static_cast<std::size_t>(e[0])] != Graph_region::separator) add_to_halo(e[0], e[1]);
  return parts;
}

}  // namespace Conformal_geometry_processing

#endif
