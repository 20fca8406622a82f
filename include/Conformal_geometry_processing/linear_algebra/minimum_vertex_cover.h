// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_MINIMUM_VERTEX_COVER_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_MINIMUM_VERTEX_COVER_H

#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief vertices of a bipartite graph that touch all of its edges, ascending on each side.
struct Vertex_cover {
  std::vector<int> left, right;
};

namespace internal {

/// A largest set of disjoint edges of a bipartite graph (Hopcroft and Karp 1973), without
/// recursion.
class Bipartite_matching {
 public:
  Bipartite_matching(int left_size, int right_size, const std::vector<std::array<int, 2>>& edges)
      : m_offsets(at(left_size) + 1, 0),
        m_targets(edges.size()),
        m_mate_of_left(at(left_size), -1),
        m_mate_of_right(at(right_size), -1),
        m_level(at(left_size), -1)
  {
    for (const auto& e : edges) ++m_offsets[at(e[0]) + 1];
    std::partial_sum(m_offsets.begin(), m_offsets.end(), m_offsets.begin());
    m_next.assign(m_offsets.begin(), m_offsets.end() - 1);
    for (const auto& e : edges) m_targets[at(m_next[at(e[0])]++)] = e[1];
    match_greedily();
    while (find_levels()) {
      m_next.assign(m_offsets.begin(), m_offsets.end() - 1);
      for (int x = 0; x < left_size; ++x)
        if (m_mate_of_left[at(x)] < 0) augment(x);
    }
  }

  /// -1 where x has none
  int mate_of_left(int x) const { return m_mate_of_left[at(x)]; }

  /// whether an alternating path leads from some left vertex without a mate to x
  bool is_reached(int x) const { return m_level[at(x)] >= 0; }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  void match(int x, int y)
  {
    m_mate_of_left[at(x)] = y;
    m_mate_of_right[at(y)] = x;
  }

  void match_greedily()
  {
    for (int x = 0; x < static_cast<int>(m_mate_of_left.size()); ++x)
      for (int k = m_offsets[at(x)]; k < m_offsets[at(x) + 1] && mate_of_left(x) < 0; ++k)
        if (m_mate_of_right[at(m_targets[at(k)])] < 0) match(x, m_targets[at(k)]);
  }

  // Distances of left vertices from those without a mate; whether a free right vertex was met.
  bool find_levels()
  {
    std::vector<int> queue;
    for (int x = 0; x < static_cast<int>(m_level.size()); ++x) {
      m_level[at(x)] = mate_of_left(x) < 0 ? 0 : -1;
      if (m_level[at(x)] == 0) queue.push_back(x);
    }
    bool is_free_met = false;
    for (std::size_t head = 0; head < queue.size(); ++head) {
      const int x = queue[head];
      for (int k = m_offsets[at(x)]; k < m_offsets[at(x) + 1]; ++k) {
        const int z = m_mate_of_right[at(m_targets[at(k)])];
        if (z < 0) is_free_met = true;
        if (z < 0 || m_level[at(z)] >= 0) continue;
        m_level[at(z)] = m_level[at(x)] + 1;
        queue.push_back(z);
      }
    }
    return is_free_met;
  }

  // Depth first along rising levels; `m_next` is not reset, so that a phase sees an edge once.
  void augment(int root)
  {
    m_path.assign(1, root);
    while (!m_path.empty()) {
      const int x = m_path.back();
      if (m_next[at(x)] == m_offsets[at(x) + 1]) {
        m_path.pop_back();
        continue;
      }
      const int z = m_mate_of_right[at(m_targets[at(m_next[at(x)]++)])];
      if (z < 0) break;
      if (m_level[at(z)] == m_level[at(x)] + 1) m_path.push_back(z);
    }
    for (int x : m_path) match(x, m_targets[at(m_next[at(x)] - 1)]);
  }

  std::vector<int> m_offsets, m_targets, m_mate_of_left, m_mate_of_right, m_level, m_next, m_path;
};

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief a smallest set of vertices that touches every edge of a bipartite graph (Koenig 1931).
///
/// Of all smallest covers the one with the most vertices on the left.
/// O(edges sqrt(vertices)).
/// \param edges pairs (left vertex, right vertex)
inline Vertex_cover minimum_vertex_cover(int left_size, int right_size,
                                         const std::vector<std::array<int, 2>>& edges)
{
  // Every edge of the matching needs one of its ends; Koenig tells which suffices: the right one
  // exactly where the left one has a way out to a vertex without a mate.
  const internal::Bipartite_matching matching(left_size, right_size, edges);
  std::vector<char> is_covering(static_cast<std::size_t>(right_size), 0);
  Vertex_cover cover;
  for (int x = 0; x < left_size; ++x) {
    if (matching.mate_of_left(x) < 0) continue;
    if (matching.is_reached(x))
      is_covering[static_cast<std::size_t>(matching.mate_of_left(x))] = 1;
    else
      cover.left.push_back(x);
  }
  for (int y = 0; y < right_size; ++y)
    if (is_covering[static_cast<std::size_t>(y)]) cover.right.push_back(y);
  return cover;
}

}  // namespace Conformal_geometry_processing

#endif
