// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/multigrid/Prolongation.h>

#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing {

std::size_t internal::Prolongation::bytes() const
{
  return sizeof(int) * (offsets.size() + columns.size()) + sizeof(float) * weights.size();
}

internal::Prolongation smoothed_prolongation(const internal::Connection_graph& graph,
                                             const internal::Aggregation& a, double omega)
{
  internal::Prolongation P;
  P.coarse_size = a.size;
  P.offsets.reserve(static_cast<std::size_t>(graph.size()) + 1);
  P.offsets.push_back(0);
  std::vector<int> place(static_cast<std::size_t>(a.size), -1);  // of a column in the last row
  for (int i = 0; i < graph.size(); ++i) {
    const int row = P.offsets.back();
    const auto add = [&](int vertex, double weight) {
      const int c = a.aggregate_of[static_cast<std::size_t>(vertex)];
      int& k = place[static_cast<std::size_t>(c)];
      if (k < row) {
        k = static_cast<int>(P.columns.size());
        P.columns.push_back(c);
        P.weights.push_back(0);
      }
      P.weights[static_cast<std::size_t>(k)] += static_cast<float>(weight);
    };
    double sum = 0;
    for (int k = graph.begin(i); k < graph.end(i); ++k) sum += static_cast<double>(graph.weight(k));
    if (sum > 0) add(i, 1 - omega);
    for (int k = graph.begin(i); k < graph.end(i); ++k)
      add(graph.neighbor(k), omega * static_cast<double>(graph.weight(k)) / sum);
    P.offsets.push_back(static_cast<int>(P.columns.size()));
  }
  return P;
}

}  // namespace Conformal_geometry_processing
