// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Bending_matrix.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {

internal::Bending_matrix::Bending_matrix(const Fairing_patch& patch)
{
  const Mesh_view& mesh = patch.mesh();
  std::vector<std::vector<int>> edges(static_cast<std::size_t>(mesh.size_of_vertices()));
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    for (const int v : mesh.ends(k)) edges[static_cast<std::size_t>(v)].push_back(k);
  for (int v = 0; v < mesh.size_of_vertices(); ++v)
    if (patch.bends(v)) add_row(patch, v, edges[static_cast<std::size_t>(v)]);
  find_pattern(patch.size());
}

void internal::Bending_matrix::add_row(const Fairing_patch& patch, int v,
                                       const std::vector<int>& edges)
{
  m_middles.push_back(v);
  if (patch.is_free(v)) m_entries.push_back({patch.unknown(v), edges});
  for (const int k : edges) {
    const int other = patch.mesh().ends(k)[0] + patch.mesh().ends(k)[1] - v;
    if (patch.is_free(other)) m_entries.push_back({patch.unknown(other), {k}});
  }
  m_offsets.push_back(m_entries.size());
}

double internal::Bending_matrix::coefficient(std::size_t p, const Bending_energy& energy) const
{
  const std::vector<int>& edges = m_entries[p].edges;
  if (edges.size() == 1) return -energy.weights()[edges.front()];
  double sum = 0;
  for (const int k : edges) sum += energy.weights()[k];
  return sum;
}

void internal::Bending_matrix::find_pattern(int size)
{
  std::vector<std::vector<int>> columns(static_cast<std::size_t>(size));
  const auto for_each_pair = [this](auto visit) {
    for (std::size_t s = 0; s + 1 < m_offsets.size(); ++s)
      for (std::size_t p = m_offsets[s]; p < m_offsets[s + 1]; ++p)
        for (std::size_t q = m_offsets[s]; q <= p; ++q)
          visit(std::minmax(m_entries[p].unknown, m_entries[q].unknown));
  };
  for_each_pair([&](const std::pair<int, int>& ends) {
    columns[static_cast<std::size_t>(ends.first)].push_back(ends.second);
  });
  auto pattern = std::make_shared<Sparse_pattern>();
  pattern->offsets.push_back(0);
  for (std::vector<int>& rows : columns) {
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    pattern->indices.insert(pattern->indices.end(), rows.begin(), rows.end());
    pattern->offsets.push_back(pattern->size_of_entries());
  }
  for_each_pair([&](const std::pair<int, int>& ends) {
    m_places.push_back(pattern->find(ends.second, ends.first));
  });
  m_pattern = std::move(pattern);
}

}  // namespace Conformal_geometry_processing
