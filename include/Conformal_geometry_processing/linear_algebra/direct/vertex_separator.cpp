// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/direct/vertex_separator.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

void Separator_band::add(int v)
{
  int& k = number[static_cast<std::size_t>(v)];
  if (k >= 0) return;
  k = static_cast<int>(vertices.size());
  vertices.push_back(v);
  graph.is_source.push_back(0);
  graph.is_sink.push_back(0);
}

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
