// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_MULTIGRID_AGGREGATE_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_MULTIGRID_AGGREGATE_H

#include <Conformal_geometry_processing/linear_algebra/multigrid/strong_connections.h>

#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief a partition of the vertices of a graph into connected groups.
struct Aggregation {
  std::vector<int> aggregate_of;  ///< per vertex; -1 where it has no connection at all
  int size = 0;                   ///< number of aggregates
};

namespace internal {

// Every vertex whose neighbors are all free becomes the centre of an aggregate with them.
inline void seed_aggregates(const Connection_graph& graph, Aggregation& a)
{
  const auto of = [&](int i) -> int& { return a.aggregate_of[static_cast<std::size_t>(i)]; };
  for (int i = 0; i < graph.size(); ++i) {
    bool is_free = of(i) < 0 && graph.begin(i) < graph.end(i);
    for (int k = graph.begin(i); k < graph.end(i) && is_free; ++k)
      is_free = of(graph.neighbor(k)) < 0;
    if (!is_free) continue;
    of(i) = a.size;
    for (int k = graph.begin(i); k < graph.end(i); ++k) of(graph.neighbor(k)) = a.size;
    ++a.size;
  }
}

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief groups every vertex with its neighborhood: about nine vertices each on a triangle mesh.
///
/// Vertices with free neighborhoods become centres, in the order of their numbers; a vertex that is
/// left over joins the neighborhood to which its connection is strongest (there is one, for else it
/// would have become a centre). Every aggregate has at least two vertices. Linear time.
inline Aggregation aggregate(const Connection_graph& graph)
{
  Aggregation a;
  a.aggregate_of.assign(static_cast<std::size_t>(graph.size()), -1);
  internal::seed_aggregates(graph, a);
  // By the neighborhoods alone, so that aggregates stay round.
  const std::vector<int> seeded = a.aggregate_of;
  for (int i = 0; i < graph.size(); ++i) {
    if (seeded[static_cast<std::size_t>(i)] >= 0) continue;
    float strongest = 0;
    for (int k = graph.begin(i); k < graph.end(i); ++k) {
      const int other = seeded[static_cast<std::size_t>(graph.neighbor(k))];
      if (other < 0 || graph.weight(k) <= strongest) continue;
      strongest = graph.weight(k);
      a.aggregate_of[static_cast<std::size_t>(i)] = other;
    }
  }
  return a;
}

}  // namespace Conformal_geometry_processing

#endif
