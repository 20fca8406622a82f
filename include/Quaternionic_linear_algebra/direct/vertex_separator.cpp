// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/direct/vertex_separator.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace Conformal_geometry_processing {
namespace internal {

/// Computes a maximum set of vertex-disjoint paths from sources to sinks by Dinic's method (1970),
/// without recursion.
///
/// A search for an augmenting path visits a vertex in two states: 2v on entry, 2v + 1 on exit. A
/// vertex on a path cannot be passed from entry to exit; the search may instead follow that path
/// backward and reroute its end.
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

  /// Side of the first cut that separates sources and sinks; vertices reachable by a further path
  /// are left
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

  // The only successor of an entry state: the exit, or backward along the path; none if there is
  // none
  int after_entry(int v) const
  {
    if (m_next[at(v)] == none) return 2 * v + 1;
    return m_previous[at(v)] >= 0 ? 2 * m_previous[at(v)] + 1 : none;
  }

  // Breadth-first search up to the first free sink; returns whether there is one.
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

  // Depth-first search along increasing levels. Dead ends are visited only once per phase.
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

  // Updates the paths along the states found; vertices that are left backward become free.
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
  std::vector<int> m_offsets, m_targets;  // adjacency lists
  std::vector<int> m_next, m_previous;    // on the path through a vertex
  std::vector<int> m_level, m_edge, m_queue, m_path;
};

/// Candidate vertices of a separator, with local indices.
struct Separator_band {
  std::vector<int> vertices, number;  // band to region; region to band, -1 outside
  Terminal_graph graph;

  void add(int v)
  {
    int& k = number[static_cast<std::size_t>(v)];
    if (k >= 0) return;
    k = static_cast<int>(vertices.size());
    vertices.push_back(v);
    graph.is_source.push_back(0);
    graph.is_sink.push_back(0);
  }
};

}  // namespace internal

std::vector<internal::Side> minimum_vertex_cut(const internal::Terminal_graph& graph)
{
  const internal::Disjoint_paths paths(graph);
  std::vector<internal::Side> sides(graph.is_source.size());
  for (int v = 0; v < graph.size(); ++v) sides[static_cast<std::size_t>(v)] = paths.side(v);
  return sides;
}

internal::Graph_region graph_region(const Sparse_pattern& pattern,
                                    const Eigen::Matrix3Xd& positions)
{
  internal::Graph_region region;
  const int n = pattern.size();
  region.vertices.resize(static_cast<std::size_t>(n));
  std::iota(region.vertices.begin(), region.vertices.end(), 0);
  region.edges.reserve(pattern.indices.size() - region.vertices.size());
  for (int j = 0; j < n; ++j)
    for (int k = pattern.offsets[static_cast<std::size_t>(j)] + 1;
         k < pattern.offsets[static_cast<std::size_t>(j) + 1]; ++k)
      region.edges.push_back({j, pattern.indices[static_cast<std::size_t>(k)]});
  if (n == 0) return region;
  const Eigen::Vector3d low = positions.rowwise().minCoeff(), high = positions.rowwise().maxCoeff();
  const Eigen::Vector3d center = low / 2 + high / 2;  // low + high may overflow
  const double radius = (high / 2 - low / 2).maxCoeff();
  region.positions.resize(n, 3);
  for (int a = 0; a < 3; ++a)
    if (radius > 0)
      region.positions.col(a) =
          ((positions.row(a).transpose().array() - center[a]) / radius).cast<float>();
    else
      region.positions.col(a).setZero();
  return region;
}

std::array<internal::Graph_region, 2> split(const internal::Graph_region& region,
                                            const std::vector<internal::Side>& sides)
{
  std::array<internal::Graph_region, 2> parts;
  std::vector<int> place(sides.size(), -1);  // local index; -1 for the separator
  for (internal::Graph_region& part : parts) part.vertices.reserve(sides.size());
  const auto part_of = [&](int v) -> internal::Graph_region& {
    return parts[sides[static_cast<std::size_t>(v)] == internal::Side::left ? 0 : 1];
  };
  for (int v = 0; v < region.size(); ++v)
    if (sides[static_cast<std::size_t>(v)] != internal::Side::separator) {
      place[static_cast<std::size_t>(v)] = part_of(v).size();
      part_of(v).vertices.push_back(region.vertices[static_cast<std::size_t>(v)]);
    }
  for (internal::Graph_region& part : parts) {
    part.positions.resize(part.size(), 3);
    part.edges.reserve(region.edges.size() * static_cast<std::size_t>(part.size()) /
                       region.vertices.size());
  }
  for (int v = 0; v < region.size(); ++v)
    if (place[static_cast<std::size_t>(v)] >= 0)
      part_of(v).positions.row(place[static_cast<std::size_t>(v)]) = region.positions.row(v);
  for (const auto& e : region.edges) {
    const int a = place[static_cast<std::size_t>(e[0])], b = place[static_cast<std::size_t>(e[1])];
    if (a >= 0 && b >= 0) part_of(e[0]).edges.push_back({a, b});
  }
  return parts;
}

namespace internal {

/// \param lighter_side the side of the sources
Separator_band separator_band(const Graph_region& region, const std::vector<Side>& sides,
                              Side lighter_side)
{
  const auto side = [&](int v) { return sides[static_cast<std::size_t>(v)]; };
  Separator_band band;
  band.number.assign(sides.size(), -1);
  for (int v = 0; v < region.size(); ++v)
    if (side(v) == Side::separator) band.add(v);
  for (const auto& e : region.edges)  // edges that bypass the band are added to it
    if (side(e[0]) != side(e[1]) && side(e[0]) != Side::separator &&
        side(e[1]) != Side::separator) {
      band.add(e[0]);
      band.add(e[1]);
    }
  const auto number = [&](int v) { return band.number[static_cast<std::size_t>(v)]; };
  const auto mark = [&](int k, Side s) {
    (s == lighter_side ? band.graph.is_source : band.graph.is_sink)[static_cast<std::size_t>(k)] =
        1;
  };
  for (std::size_t k = 0; k < band.vertices.size(); ++k)
    if (side(band.vertices[k]) != Side::separator)
      mark(static_cast<int>(k), side(band.vertices[k]));
  for (const auto& e : region.edges) {
    const int a = number(e[0]), b = number(e[1]);
    if (a >= 0 && b >= 0)
      band.graph.edges.push_back({a, b});
    else if (a >= 0)
      mark(a, side(e[1]));
    else if (b >= 0)
      mark(b, side(e[0]));
  }
  return band;
}

}  // namespace internal

void thin_separator(const internal::Graph_region& region, std::vector<internal::Side>& sides)
{
  const auto lefts = std::count(sides.begin(), sides.end(), internal::Side::left);
  const auto rights = std::count(sides.begin(), sides.end(), internal::Side::right);
  const internal::Side lighter_side =
                           lefts >= rights ? internal::Side::left : internal::Side::right,
                       other_side = lighter_side == internal::Side::left ? internal::Side::right
                                                                         : internal::Side::left;
  const internal::Separator_band band = internal::separator_band(region, sides, lighter_side);
  const std::vector<internal::Side> cut = minimum_vertex_cut(band.graph);
  for (std::size_t k = 0; k < cut.size(); ++k)
    sides[static_cast<std::size_t>(band.vertices[k])] =
        cut[k] == internal::Side::separator
            ? internal::Side::separator
            : (cut[k] == internal::Side::left ? lighter_side : other_side);
}

}  // namespace Conformal_geometry_processing
