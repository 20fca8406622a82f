// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_MINIMUM_VERTEX_CUT_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_MINIMUM_VERTEX_CUT_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// where a vertex is after a separator has been taken out of a graph
enum class Side : char { left, right, separator };

/// \ingroup PkgLinearAlgebra
/// \brief a graph with vertices that must not end up right (sources) and that must not end up left
/// (sinks).
struct Terminal_graph {
  std::vector<std::array<int, 2>> edges;
  std::vector<char> is_source, is_sink;  ///< one for each vertex; one vertex may be both

  int size() const { return static_cast<int>(is_source.size()); }
};

namespace internal {

/// The greatest number of paths from sources to sinks without a common vertex, by Dinic's method
/// (1970), without recursion.
///
/// A search for another path meets a vertex in two states: 2v on entry, 2v + 1 on exit. Through a
/// vertex of a path there is no way from entry to exit; but a search may go back along the path it
/// entered, whose end is led elsewhere.
class Disjoint_paths {
 public:
  explicit Disjoint_paths(const Terminal_graph& graph)
      : m_graph(graph),
        m_offsets(at(graph.size()) + 1, 0),
        m_targets(2 * graph.edges.size()),
        m_next(at(graph.size()), none),
        m_previous(at(graph.size()), none),
        m_level(2 * at(graph.size()))
  {
    find_neighbours();
    while (find_levels()) {
      m_edge.assign(m_offsets.begin(), m_offsets.end() - 1);
      for (int v = 0; v < graph.size(); ++v)
        if (may_begin(v)) augment(v);
    }
  }

  /// left of the first cut that separates the sources from the sinks: what another path could reach
  Side side(int v) const
  {
    if (m_level[at(2 * v + 1)] >= 0) return Side::left;
    return m_level[at(2 * v)] >= 0 || m_graph.is_source[at(v)] ? Side::separator : Side::right;
  }

 private:
  enum : int { none = -1, terminal = -2 };

  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  static bool is_exit(int state) { return (state & 1) != 0; }

  bool may_begin(int v) const
  {
    return m_graph.is_source[at(v)] && m_previous[at(v)] != terminal && m_level[at(2 * v)] == 0;
  }

  bool may_end(int v) const { return m_graph.is_sink[at(v)] && m_next[at(v)] != terminal; }

  void find_neighbours()
  {
    for (const auto& e : m_graph.edges) {
      ++m_offsets[at(e[0]) + 1];
      ++m_offsets[at(e[1]) + 1];
    }
    std::partial_sum(m_offsets.begin(), m_offsets.end(), m_offsets.begin());
    m_edge.assign(m_offsets.begin(), m_offsets.end() - 1);
    for (const auto& e : m_graph.edges) {
      m_targets[at(m_edge[at(e[0])]++)] = e[1];
      m_targets[at(m_edge[at(e[1])]++)] = e[0];
    }
  }

  // The state to which alone an entry leads: the exit, or back along the path; none if there is no.
  int after_entry(int v) const
  {
    if (m_next[at(v)] == none) return 2 * v + 1;
    return m_previous[at(v)] >= 0 ? 2 * m_previous[at(v)] + 1 : none;
  }

  // Breadth first, as far as the first sink where a path may end; whether there is one.
  bool find_levels()
  {
    std::fill(m_level.begin(), m_level.end(), -1);
    m_queue.clear();
    for (int v = 0; v < m_graph.size(); ++v)
      if (m_graph.is_source[at(v)] && m_previous[at(v)] != terminal) reach(2 * v, 0);
    int last = (std::numeric_limits<int>::max)();
    for (std::size_t head = 0; head < m_queue.size(); ++head) {
      const int state = m_queue[head], v = state / 2, level = m_level[at(state)];
      if (level >= last) break;
      if (!is_exit(state)) {
        if (after_entry(v) != none) reach(after_entry(v), level + 1);
        continue;
      }
      if (may_end(v)) last = level;
      if (m_next[at(v)] != none) reach(2 * v, level + 1);
      for (int k = m_offsets[at(v)]; k < m_offsets[at(v) + 1]; ++k)
        reach(2 * m_targets[at(k)], level + 1);
    }
    return last != (std::numeric_limits<int>::max)();
  }

  void reach(int state, int level)
  {
    if (m_level[at(state)] >= 0) return;
    m_level[at(state)] = level;
    m_queue.push_back(state);
  }

  // Depth first along rising levels. A state without a way on is never tried again in a phase.
  void augment(int root)
  {
    m_path.assign(1, 2 * root);
    while (!m_path.empty()) {
      const int state = m_path.back();
      if (is_exit(state) && may_end(state / 2)) return update();
      const int next = find_next(state);
      if (next == none) {
        m_level[at(state)] = -1;
        m_path.pop_back();
      } else {
        m_path.push_back(next);
      }
    }
  }

  int find_next(int state)
  {
    const int v = state / 2, level = m_level[at(state)] + 1;
    const auto leads_on = [&](int s) { return s != none && m_level[at(s)] == level; };
    if (!is_exit(state)) return leads_on(after_entry(v)) ? after_entry(v) : none;
    if (m_next[at(v)] != none && leads_on(2 * v)) return 2 * v;
    for (int& k = m_edge[at(v)]; k < m_offsets[at(v) + 1]; ++k)
      if (leads_on(2 * m_targets[at(k)])) return 2 * m_targets[at(k)];
    return none;
  }

  // Leads the paths along the states found; vertices that are left backwards become free.
  void update()
  {
    int from = terminal;
    for (std::size_t i = 0; i < m_path.size(); ++i) {
      const int v = m_path[i] / 2;
      m_level[at(m_path[i])] = -1;
      if (is_exit(m_path[i])) {
        from = v;
        if (i + 1 < m_path.size() && m_path[i + 1] == 2 * v)
          m_next[at(v)] = m_previous[at(v)] = none;
      } else if (i == 0 || m_path[i - 1] != 2 * v + 1) {
        m_previous[at(v)] = from;
        if (from >= 0) m_next[at(from)] = v;
      }
    }
    m_next[at(from)] = terminal;
  }

  const Terminal_graph& m_graph;
  std::vector<int> m_offsets, m_targets;  // the neighbours of each vertex
  std::vector<int> m_next, m_previous;    // on the path of a vertex
  std::vector<int> m_level, m_edge, m_queue, m_path;
};

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief a smallest set of vertices without which no path leads from a source to a sink (Menger
/// 1927); of all smallest ones the one nearest to the sources.
///
/// For sources and sinks that are the two sides of a bipartite graph it is a smallest vertex cover
/// (Koenig 1931). O(edges sqrt(vertices)) at worst.
/// \return the side of each vertex. A source is never right, a sink never left.
inline std::vector<Side> minimum_vertex_cut(const Terminal_graph& graph)
{
  const internal::Disjoint_paths paths(graph);
  std::vector<Side> sides(graph.is_source.size());
  for (int v = 0; v < graph.size(); ++v) sides[static_cast<std::size_t>(v)] = paths.side(v);
  return sides;
}

}  // namespace Conformal_geometry_processing

#endif
