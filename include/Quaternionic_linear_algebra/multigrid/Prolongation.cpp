// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/multigrid/Prolongation.h>

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

namespace internal {

Sparse_rows<float> transpose(const Prolongation& P)
{
  Sparse_rows<float> R(P.coarse_size);
  for (const int c : P.columns) ++R.offsets[static_cast<std::size_t>(c) + 1];
  std::vector<int> next = R.allocate();
  for (int i = 0; i < P.fine_size(); ++i)
    P.for_each_in_row(i, [&](int c, float weight) {
      const std::size_t k = static_cast<std::size_t>(next[static_cast<std::size_t>(c)]++);
      R.columns[k] = i;
      R.values[k] = weight;
    });
  return R;
}

}  // namespace internal

}  // namespace Conformal_geometry_processing
