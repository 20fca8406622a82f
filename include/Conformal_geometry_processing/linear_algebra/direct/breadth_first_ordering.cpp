// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/direct/breadth_first_ordering.h>

#include <cstddef>
#include <numeric>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

Neighbour_lists neighbour_lists(const Sparse_pattern& pattern)
{
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  Neighbour_lists lists;
  lists.offsets.assign(at(pattern.size()) + 1, 0);
  const auto for_each_edge = [&](auto action) {
    for (int j = 0; j < pattern.size(); ++j)
      for (int k = pattern.offsets[at(j)] + 1; k < pattern.offsets[at(j) + 1]; ++k)
        action(j, pattern.indices[at(k)]);
  };
  for_each_edge([&](int i, int j) {
    ++lists.offsets[at(i) + 1];
    ++lists.offsets[at(j) + 1];
  });
  std::partial_sum(lists.offsets.begin(), lists.offsets.end(), lists.offsets.begin());
  lists.neighbours.resize(at(lists.offsets.back()));
  std::vector<int> next = lists.offsets;
  for_each_edge([&](int i, int j) {
    lists.neighbours[at(next[at(i)]++)] = j;
    lists.neighbours[at(next[at(j)]++)] = i;
  });
  return lists;
}

void append_by_distance(const Neighbour_lists& lists, int start, int mark, std::vector<int>& marks,
                        Ordering& order)
{
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  std::size_t next = order.size();
  order.push_back(start);
  marks[at(start)] = mark;
  for (; next < order.size(); ++next) {
    const std::size_t v = at(order[next]);
    for (int k = lists.offsets[v]; k < lists.offsets[v + 1]; ++k) {
      const int w = lists.neighbours[at(k)];
      if (marks[at(w)] == mark) continue;
      marks[at(w)] = mark;
      order.push_back(w);
    }
  }
}

}  // namespace internal

internal::Ordering breadth_first_ordering(const Sparse_pattern& pattern)
{
  const internal::Neighbour_lists lists = internal::neighbour_lists(pattern);
  const std::size_t n = static_cast<std::size_t>(pattern.size());
  std::vector<int> marks(n, 0);
  internal::Ordering order, trial;
  order.reserve(n);
  for (int v = 0; v < pattern.size(); ++v) {
    if (marks[static_cast<std::size_t>(v)] != 0) continue;
    trial.clear();
    internal::append_by_distance(lists, v, 1, marks, trial);
    // The vertex farthest from an arbitrary one is peripheral.
    internal::append_by_distance(lists, trial.back(), 2, marks, order);
  }
  return order;
}

}  // namespace Conformal_geometry_processing
