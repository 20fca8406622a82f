// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_VERTEX_SEPARATOR_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_VERTEX_SEPARATOR_H

#include <Conformal_geometry_processing/linear_algebra/Graph_region.h>
#include <Conformal_geometry_processing/linear_algebra/minimum_vertex_cover.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief moves the fewest vertices that touch all edges between left and right to the separator,
/// rather from the greater side. O(edges + cut edges^(3/2)).
/// \param[in,out] side `left` or `right` for each vertex; `separator` too afterwards
inline void separate(const Graph_region& region, std::vector<char>& side)
{
  const auto lefts = std::count(side.begin(), side.end(), char(Graph_region::left));
  const char first = 2 * lefts >= region.size() ? Graph_region::left : Graph_region::right;
  // The ends of the cut edges: of the greater side, of the other side; and their numbers there.
  std::array<std::vector<int>, 2> ends;
  std::vector<int> number(side.size(), -1);
  Graph_region::Pairs cut;
  const auto number_of = [&](int v, std::vector<int>& list) {
    int& k = number[static_cast<std::size_t>(v)];
    if (k < 0) {
      k = static_cast<int>(list.size());
      list.push_back(v);
    }
    return k;
  };
  for (const auto& e : region.edges) {
    const char a = side[static_cast<std::size_t>(e[0])], b = side[static_cast<std::size_t>(e[1])];
    if (a == b) continue;
    const int x = number_of(a == first ? e[0] : e[1], ends[0]);
    cut.push_back({x, number_of(a == first ? e[1] : e[0], ends[1])});
  }
  const Vertex_cover cover =
      minimum_vertex_cover(static_cast<int>(ends[0].size()), static_cast<int>(ends[1].size()), cut);
  const auto move = [&](int v) { side[static_cast<std::size_t>(v)] = Graph_region::separator; };
  for (int x : cover.left) move(ends[0][static_cast<std::size_t>(x)]);
  for (int y : cover.right) move(ends[1][static_cast<std::size_t>(y)]);
}

}  // namespace Conformal_geometry_processing

#endif
