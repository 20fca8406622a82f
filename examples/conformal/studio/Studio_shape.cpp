// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Studio_shape.h"

#include "conformal/input/Defects.h"
#include "conformal/report/conformal_charts.h"

#include <cstddef>

namespace conformal {
namespace {

/// of each vertex of the mesh, in the file before its repair
std::vector<int> vertex_in_file(const Surface_input& input)
{
  std::vector<int> origin = input.vertex_in_file;
  if (input.repair)
    for (int& v : origin) v = input.repair->vertex_in_file[static_cast<std::size_t>(v)];
  return origin;
}

}  // namespace

Studio_shape shape_of(const Surface_input& input)
{
  const std::string& path = input.file.path;
  const std::size_t vertices =
      input.repair ? input.repair->new_vertex.size() : input.file.points.size();
  return {path.substr(path.find_last_of("/\\") + 1),  // not found: from 0
          path,
          input.mesh,
          vertex_in_file(input),
          static_cast<int>(vertices),
          input.repair.has_value(),
          input.notes};
}

Studio_shape parse_shape(std::string_view bytes, const std::string& name, bool is_repaired)
{
  const Surface_input input = parse_surface_input(bytes, name, is_repaired);
  require_surface(input);
  return shape_of(input);
}

std::vector<float> squares_of(const Studio_shape& shape)
{
  std::vector<float> squares;
  for (const auto& [u, v] : conformal_charts(shape.mesh)) {
    squares.push_back(static_cast<float>(u));
    squares.push_back(static_cast<float>(v));
  }
  return squares;
}

}  // namespace conformal
