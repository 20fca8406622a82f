// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/vertex_graph.h>

#include <array>
#include <vector>

namespace Conformal_geometry_processing {

std::shared_ptr<const Sparse_pattern> vertex_graph(const Surface_ref& surface)
{
  std::vector<std::array<int, 2>> ends;
  ends.reserve(static_cast<std::size_t>(surface.size_of_edges()));
  for (int k = 0; k < surface.size_of_edges(); ++k)
    if (surface.ends(k)[0] != surface.ends(k)[1]) ends.push_back(surface.ends(k));
  if (!std::is_sorted(ends.begin(), ends.end())) std::sort(ends.begin(), ends.end());
  const auto is_same = [](const auto& a, const auto& b) { return a[0] == b[0] && a[1] == b[1]; };
  ends.erase(std::unique(ends.begin(), ends.end(), is_same), ends.end());
  auto pattern = std::make_shared<Sparse_pattern>();
  const int n = surface.size_of_vertices();
  pattern->offsets.reserve(static_cast<std::size_t>(n) + 1);
  pattern->indices.reserve(static_cast<std::size_t>(n) + ends.size());
  auto end = ends.begin();
  for (int i = 0; i < n; ++i) {
    pattern->offsets.push_back(static_cast<int>(pattern->indices.size()));
    pattern->indices.push_back(i);
    for (; end != ends.end() && (*end)[0] == i; ++end) pattern->indices.push_back((*end)[1]);
  }
  pattern->offsets.push_back(static_cast<int>(pattern->indices.size()));
  return pattern;
}

}  // namespace Conformal_geometry_processing
