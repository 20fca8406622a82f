// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/multigrid/aggregate.h>

#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

void seed_aggregates(const Connection_graph& graph, Aggregation& a)
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

internal::Aggregation aggregate(const internal::Connection_graph& graph)
{
  internal::Aggregation a;
  a.aggregate_of.assign(static_cast<std::size_t>(graph.size()), -1);
  internal::seed_aggregates(graph, a);
  // Considers the initial neighborhoods only, so that aggregates stay round.
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
