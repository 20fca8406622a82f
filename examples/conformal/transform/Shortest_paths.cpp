// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Shortest_paths.h"

#include "conformal/process/at.h"

#include <array>
#include <cmath>

namespace conformal {

namespace {

bool is_at_boundary(const CGP::Mesh_view& mesh, int k)
{
  return mesh.twin(*mesh.halfedges_begin(k)) < 0;
}

}  // namespace

double length(const CGP::Mesh_view& mesh, int k)
{
  return is_at_boundary(mesh, k) ? 0 : mesh.vector(*mesh.halfedges_begin(k)).norm();
}

Shortest_paths::Shortest_paths(const CGP::Mesh_view& mesh, const Edge_set& ways)
    : m_mesh(mesh),
      m_edges(at(mesh.size_of_vertices())),
      m_distance(m_edges.size(), HUGE_VAL),
      m_first_edge(m_edges.size(), -1)
{
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    if (ways[at(k)])
      for (const int v : mesh.ends(k)) m_edges[at(v)].push_back(k);
}

void Shortest_paths::add_root(int root)
{
  reach(root, 0, -1);
  while (!m_nearest.empty()) {
    const auto [distance, v] = m_nearest.top();
    m_nearest.pop();
    if (-distance > m_distance[at(v)]) continue;
    m_farthest.emplace(-distance, -v);
    ++m_steps;
    for (const int k : m_edges[at(v)]) reach(other_end(k, v), length(m_mesh, k) - distance, k);
  }
}

double Shortest_paths::distance(int v) const
{
  return m_distance[at(v)];
}

bool Shortest_paths::has(int k) const
{
  const auto& ends = m_mesh.ends(k);
  return m_first_edge[at(ends[0])] == k || m_first_edge[at(ends[1])] == k;
}

int Shortest_paths::farthest_vertex()
{
  const auto is_outdated = [this](const std::pair<double, int>& entry) {
    return entry.first > m_distance[at(-entry.second)];
  };
  while (is_outdated(m_farthest.top())) m_farthest.pop();
  return -m_farthest.top().second;
}

void Shortest_paths::add_path(int v, Edge_set& edges) const
{
  for (int k = m_first_edge[at(v)]; k >= 0 && !edges[at(k)]; k = m_first_edge[at(v)]) {
    edges[at(k)] = 1;
    v = other_end(k, v);
  }
}

int Shortest_paths::other_end(int k, int v) const
{
  const auto& ends = m_mesh.ends(k);
  return ends[0] == v ? ends[1] : ends[0];
}

void Shortest_paths::reach(int first, double distance, int by)
{
  std::vector<std::array<int, 2>> reached = {{first, by}};
  while (!reached.empty()) {
    const auto [v, edge] = reached.back();
    reached.pop_back();
    if (distance >= m_distance[at(v)]) continue;
    m_distance[at(v)] = distance;
    m_first_edge[at(v)] = edge;
    m_nearest.emplace(-distance, v);
    for (const int k : m_edges[at(v)])
      if (is_at_boundary(m_mesh, k)) reached.push_back({other_end(k, v), k});
  }
}

}  // namespace conformal
