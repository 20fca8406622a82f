// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/direct/Ordering.h>

#include <Eigen/Core>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include <cstddef>
#include <numeric>

namespace Conformal_geometry_processing {

std::vector<int> inverse_permutation(const internal::Ordering& order)
{
  std::vector<int> inverse(order.size(), -1);
  for (std::size_t k = 0; k < order.size(); ++k) {
    const auto old = static_cast<std::size_t>(order[k]);
    if (order[k] < 0 || old >= order.size() || inverse[old] >= 0) return {};
    inverse[old] = static_cast<int>(k);
  }
  return inverse;
}

internal::Ordering amd_ordering(const Sparse_pattern& pattern)
{
  // Values have no effect: of the smallest type, for they are copied. A matrix that is known to be
  // symmetric is not added to its transpose.
  using Graph = Eigen::SparseMatrix<char, Eigen::ColMajor, int>;
  const std::vector<char> ones(pattern.indices.size(), 1);
  const Eigen::Map<const Graph> lower(pattern.size(), pattern.size(), pattern.size_of_entries(),
                                      pattern.offsets.data(), pattern.indices.data(), ones.data());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> permutation;
  Eigen::AMDOrdering<int>()(lower.selfadjointView<Eigen::Lower>(), permutation);
  return internal::Ordering(permutation.indices().data(),
                            permutation.indices().data() + pattern.size());
}

Sparse_pattern expanded_pattern(const Sparse_pattern& pattern, int width)
{
  const std::size_t w = static_cast<std::size_t>(width);
  Sparse_pattern expanded;
  expanded.offsets.reserve(w * pattern.offsets.size());
  expanded.indices.reserve(w * w * pattern.indices.size());
  expanded.offsets.push_back(0);
  for (std::size_t j = 0; j + 1 < pattern.offsets.size(); ++j)
    for (int c = 0; c < width; ++c) {
      const int diagonal = pattern.offsets[j];
      for (int k = diagonal; k < pattern.offsets[j + 1]; ++k)
        for (int r = k == diagonal ? c : 0; r < width; ++r)
          expanded.indices.push_back(width * pattern.indices[static_cast<std::size_t>(k)] + r);
      expanded.offsets.push_back(expanded.size_of_entries());
    }
  return expanded;
}

internal::Ordering expanded_ordering(const internal::Ordering& order, int width)
{
  internal::Ordering expanded;
  expanded.reserve(static_cast<std::size_t>(width) * order.size());
  for (const int i : order)
    for (int r = 0; r < width; ++r) expanded.push_back(width * i + r);
  return expanded;
}

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
