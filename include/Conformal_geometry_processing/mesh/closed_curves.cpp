// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/closed_curves.h>

#include <Conformal_geometry_processing/mesh/requirements.h>

#include <cstddef>
#include <string>
#include <vector>

namespace Conformal_geometry_processing {

std::vector<std::vector<int>> internal::closed_curves(const Mesh_view& mesh,
                                                      const std::vector<char>& is_marked,
                                                      const std::string& function,
                                                      const std::function<std::string(int)>& name)
{
  const auto at = [](int v) { return static_cast<std::size_t>(v); };
  std::vector<std::vector<int>> neighbors(is_marked.size());
  for (int e = 0; e < mesh.size_of_edges(); ++e) {
    const auto [i, j] = mesh.ends(e);
    if (!is_marked[at(i)] || !is_marked[at(j)]) continue;
    neighbors[at(i)].push_back(j);
    neighbors[at(j)].push_back(i);
  }
  refuse_if_any(
      static_cast<int>(is_marked.size()),
      [&](int v) { return is_marked[at(v)] && neighbors[at(v)].size() != 2; }, name, function,
      "#vertex on no closed curve", "two neighbours on it are needed, and no more");
  std::vector<std::vector<int>> curves;
  std::vector<char> is_visited(is_marked.size(), 0);
  for (int first = 0; first < mesh.size_of_vertices(); ++first) {
    if (!is_marked[at(first)] || is_visited[at(first)]) continue;
    curves.emplace_back();
    for (int last = -1, here = first; !is_visited[at(here)];) {
      curves.back().push_back(here);
      is_visited[at(here)] = 1;
      const std::vector<int>& next = neighbors[at(here)];
      const int before = last;
      last = here;
      here = next[0] == before ? next[1] : next[0];
    }
  }
  return curves;
}

}  // namespace Conformal_geometry_processing
