// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "separate_fans.h"

#include "select_faces.h"

#include "conformal/process/at.h"

#include <cstddef>

namespace conformal {
namespace {}  // namespace

Separated_vertices separate_fans(Surface_file& file, const Corner_fans& fans)
{
  std::vector<int>& corners = file.polygons.corners;
  std::vector<int> fan_of_vertex(file.points.size(), -1), copied;
  std::vector<int> vertex_of_fan(at(fans.size()), -1), number(at(fans.size()), -1);
  for (std::size_t c = 0; c < corners.size(); ++c) {
    const int fan = fans.of_corner(c);
    if (vertex_of_fan[at(fan)] >= 0) continue;
    vertex_of_fan[at(fan)] = corners[c];
    if (fan_of_vertex[at(corners[c])] < 0)
      fan_of_vertex[at(corners[c])] = fan;
    else
      copied.push_back(fan);
  }
  Separated_vertices separated;
  const auto number_next = [&](int fan) {
    number[at(fan)] = static_cast<int>(separated.vertex_in_file.size());
    separated.vertex_in_file.push_back(vertex_of_fan[at(fan)]);
  };
  for (const int fan : fan_of_vertex)
    if (fan >= 0) number_next(fan);
  for (const int fan : copied) number_next(fan);
  separated.copies = static_cast<int>(copied.size());
  for (std::size_t c = 0; c < corners.size(); ++c) corners[c] = number[at(fans.of_corner(c))];
  select_vertices(file, separated.vertex_in_file);
  return separated;
}

}  // namespace conformal
