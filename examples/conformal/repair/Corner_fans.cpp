// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Corner_fans.h"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <numeric>

namespace conformal {
namespace {

/// an edge as a face passes it: from the corner `from` to the corner `to`
struct Side {
  Corner_fans::Edge ends;
  int from, to;
  bool is_forward;  // from the smaller vertex to the larger
};

std::vector<Side> sorted_sides(const Polygons& polygons)
{
  std::vector<Side> sides;
  sides.reserve(polygons.corners.size());
  for (std::size_t f = 0; f < polygons.size(); ++f)
    for (std::size_t c = polygons.first[f]; c < polygons.first[f + 1]; ++c) {
      const std::size_t next = c + 1 < polygons.first[f + 1] ? c + 1 : polygons.first[f];
      const int a = polygons.corners[c], b = polygons.corners[next];
      sides.push_back(
          {{std::min(a, b), std::max(a, b)}, static_cast<int>(c), static_cast<int>(next), a < b});
    }
  std::stable_sort(sides.begin(), sides.end(),
                   [](const Side& s, const Side& t) { return s.ends < t.ends; });
  return sides;
}

}  // namespace

Corner_fans::Corner_fans(const Polygons& polygons, const std::vector<Edge>& cuts)
    : m_fan(polygons.corners.size(), -1)
{
  std::vector<int> parent(m_fan.size()), rank(m_fan.size(), 0);
  std::iota(parent.begin(), parent.end(), 0);
  boost::disjoint_sets<int*, int*> sets(rank.data(), parent.data());
  const std::vector<Side> sides = sorted_sides(polygons);
  for (auto begin = sides.begin(); begin != sides.end();) {
    const auto end =
        std::find_if(begin, sides.end(), [&](const Side& s) { return s.ends != begin->ends; });
    const auto count = end - begin;
    const bool is_cut = std::binary_search(cuts.begin(), cuts.end(), begin->ends);
    if (!is_cut && count == 2 && begin[0].is_forward != begin[1].is_forward) {
      sets.union_set(begin[0].from, begin[1].to);
      sets.union_set(begin[0].to, begin[1].from);
    } else {
      m_cut_edges += count > 1;
    }
    begin = end;
  }
  std::vector<int> number(m_fan.size(), -1);
  for (std::size_t c = 0; c < m_fan.size(); ++c) {
    int& fan = number[static_cast<std::size_t>(sets.find_set(static_cast<int>(c)))];
    if (fan < 0) fan = m_size++;
    m_fan[c] = fan;
  }
}

}  // namespace conformal
