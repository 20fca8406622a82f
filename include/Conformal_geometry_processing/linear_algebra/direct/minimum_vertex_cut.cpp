// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/direct/minimum_vertex_cut.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

Disjoint_paths::Disjoint_paths(const Terminal_graph& graph)
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

Side Disjoint_paths::side(int v) const
{
  if (m_level[at(2 * v + 1)] >= 0) return Side::left;
  return m_level[at(2 * v)] >= 0 || m_graph.is_source[at(v)] ? Side::separator : Side::right;
}

bool Disjoint_paths::may_begin(int v) const
{
  return m_graph.is_source[at(v)] && m_previous[at(v)] != terminal && m_level[at(2 * v)] == 0;
}

void Disjoint_paths::find_neighbours()
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

// The only successor of an entry state: the exit, or backward along the path; none if there is none
int Disjoint_paths::after_entry(int v) const
{
  if (m_next[at(v)] == none) return 2 * v + 1;
  return m_previous[at(v)] >= 0 ? 2 * m_previous[at(v)] + 1 : none;
}

// Breadth-first search up to the first free sink; returns whether there is one.
bool Disjoint_paths::find_levels()
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

void Disjoint_paths::reach(int state, int level)
{
  if (m_level[at(state)] >= 0) return;
  m_level[at(state)] = level;
  m_queue.push_back(state);
}

// Depth-first search along increasing levels. Dead ends are visited only once per phase.
void Disjoint_paths::augment(int root)
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

int Disjoint_paths::find_next(int state)
{
  const int v = state / 2, level = m_level[at(state)] + 1;
  const auto leads_on = [&](int s) { return s != none && m_level[at(s)] == level; };
  if (!is_exit(state)) return leads_on(after_entry(v)) ? after_entry(v) : none;
  if (m_next[at(v)] != none && leads_on(2 * v)) return 2 * v;
  for (int& k = m_edge[at(v)]; k < m_offsets[at(v) + 1]; ++k)
    if (leads_on(2 * m_targets[at(k)])) return 2 * m_targets[at(k)];
  return none;
}

// Updates the paths along the states found; vertices that are left backward become free.
void Disjoint_paths::update()
{
  int from = terminal;
  for (std::size_t i = 0; i < m_path.size(); ++i) {
    const int v = m_path[i] / 2;
    m_level[at(m_path[i])] = -1;
    if (is_exit(m_path[i])) {
      from = v;
      if (i + 1 < m_path.size() && m_path[i + 1] == 2 * v) m_next[at(v)] = m_previous[at(v)] = none;
    } else if (i == 0 || m_path[i - 1] != 2 * v + 1) {
      m_previous[at(v)] = from;
      if (from >= 0) m_next[at(from)] = v;
    }
  }
  m_next[at(from)] = terminal;
}

}  // namespace internal

std::vector<internal::Side> minimum_vertex_cut(const internal::Terminal_graph& graph)
{
  const internal::Disjoint_paths paths(graph);
  std::vector<internal::Side> sides(graph.is_source.size());
  for (int v = 0; v < graph.size(); ++v) sides[static_cast<std::size_t>(v)] = paths.side(v);
  return sides;
}

}  // namespace Conformal_geometry_processing
