// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/direct/sweep_nested_dissection.h>

#include <Conformal_geometry_processing/linear_algebra/direct/vertex_separator.h>
#include <Conformal_geometry_processing/threads/Thread_team.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

std::array<Dissection_part, 2> Dissection::cut(const Dissection_part& part)
{
  const Graph_region& region = part.region;
  std::vector<Side> sides = m_cut(region);
  thin_separator(region, sides);
  int end = part.end;
  for (int v = region.size() - 1; v >= 0; --v)
    if (sides[static_cast<std::size_t>(v)] == Side::separator)
      m_order[static_cast<std::size_t>(--end)] = region.vertices[static_cast<std::size_t>(v)];
  std::array<Graph_region, 2> halves = split(region, sides);
  const int middle = end - halves[1].size();
  return {{{std::move(halves[0]), middle}, {std::move(halves[1]), end}}};
}

void Dissection::finish(Dissection_part&& all)
{
  std::vector<Dissection_part> stack;
  stack.push_back(std::move(all));
  while (!stack.empty()) {
    Dissection_part part = std::move(stack.back());
    stack.pop_back();
    std::vector<int>& vertices = part.region.vertices;
    if (part.region.size() <= max_dissection_leaf) {
      std::sort(vertices.begin(), vertices.end(), [this](int v, int w) {
        return m_rank[static_cast<std::size_t>(v)] < m_rank[static_cast<std::size_t>(w)];
      });
      std::copy(vertices.begin(), vertices.end(),
                m_order.begin() + (part.end - part.region.size()));
    } else {
      for (Dissection_part& half : cut(part)) stack.push_back(std::move(half));
    }
  }
}

/// The first cuts form a binary tree of tasks: part t is cut into the parts 2t and 2t + 1.
void dissect_in_parallel(Dissection_part&& all, int threads, const std::vector<int>& rank,
                         Ordering& order)
{
  constexpr int parts_at_most = 128, smallest = 1000;
  std::vector<Dissection_part> parts(parts_at_most);
  parts[1] = std::move(all);
  Task_pool pool(threads);
  pool.run({1}, [&](int t) {
    Dissection dissection(rank, order);
    Dissection_part part = std::move(parts[static_cast<std::size_t>(t)]);
    if (2 * t >= parts_at_most || part.region.size() < smallest)
      return dissection.finish(std::move(part));
    std::array<Dissection_part, 2> halves = dissection.cut(part);
    part.region = Graph_region();
    for (int i = 1; i >= 0; --i) {
      parts[static_cast<std::size_t>(2 * t + i)] = std::move(halves[static_cast<std::size_t>(i)]);
      pool.push(2 * t + i);
    }
  });
}

}  // namespace internal

internal::Ordering sweep_nested_dissection(const Sparse_pattern& pattern,
                                           const Eigen::Matrix3Xd& positions)
{
  return sweep_nested_dissection(pattern, positions, amd_ordering(pattern));
}

internal::Ordering sweep_nested_dissection(const Sparse_pattern& pattern,
                                           const Eigen::Matrix3Xd& positions,
                                           const internal::Ordering& by_degree)
{
  constexpr int worth_threads = 4000;  // vertices: some milliseconds
  const std::vector<int> rank = inverse_permutation(by_degree);
  internal::Ordering order(static_cast<std::size_t>(pattern.size()));
  internal::Dissection_part all{graph_region(pattern, positions), pattern.size()};
  const int threads = pattern.size() < worth_threads ? 1 : number_of_threads();
  if (threads > 1)
    internal::dissect_in_parallel(std::move(all), threads, rank, order);
  else
    internal::Dissection(rank, order).finish(std::move(all));
  return order;
}

}  // namespace Conformal_geometry_processing
