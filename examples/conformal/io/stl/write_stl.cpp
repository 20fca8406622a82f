// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "write_stl.h"

#include "conformal/io/data/note_losses.h"
#include "conformal/io/file/little_endian.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace conformal {
namespace {

using Triangle = std::array<Point, 3>;

/// of length 1, or zero where the triangle has no area
Point normal_of(const Triangle& t)
{
  Point normal{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
    normal[k] =
        (t[1][l] - t[0][l]) * (t[2][m] - t[0][m]) - (t[1][m] - t[0][m]) * (t[2][l] - t[0][l]);
  }
  const double length = std::hypot(normal[0], normal[1], normal[2]);
  for (double& x : normal) x = length > 0 && std::isfinite(length) ? x / length : 0;
  return normal;
}

void append_point(std::string& bytes, const Point& point)
{
  for (const double x : point) append_little_endian(bytes, static_cast<float>(x));
}

void append_facet(std::string& bytes, const Triangle& triangle, std::uint16_t attribute)
{
  append_point(bytes, normal_of(triangle));
  for (const Point& point : triangle) append_point(bytes, point);
  append_little_endian(bytes, attribute);
}

/// \returns the number of triangles
std::uint32_t append_faces(std::string& bytes, const Surface_file& file)
{
  const Property* attributes = find_numbers(file.faces, "attribute");
  const auto point = [&](std::size_t c) {
    return file.points[static_cast<std::size_t>(file.polygons.corners[c])];
  };
  std::uint32_t count = 0;
  for (std::size_t f = 0; f < file.polygons.size(); ++f) {
    const std::size_t begin = file.polygons.first[f], end = file.polygons.first[f + 1];
    const double attribute = attributes != nullptr ? attributes->value(f) : 0;
    const bool fits = attribute >= 0 && attribute <= 0xffff;
    for (std::size_t c = begin + 2; c < end; ++c, ++count)
      append_facet(bytes, {point(begin), point(c - 1), point(c)},
                   static_cast<std::uint16_t>(fits ? attribute : 0));
  }
  return count;
}

// Normals follow from the points.
Written written_to_stl()
{
  Written all{"STL"};
  all.vertices = {"nx", "ny", "nz"};
  all.faces = {"attribute", "nx", "ny", "nz"};
  all.normals = Detail::corners;
  all.has_polygons = false;
  return all;
}

}  // namespace

std::string encode_stl(const Surface_file& file, std::vector<std::string>& notes)
{
  std::string facets;
  const std::uint32_t count = append_faces(facets, file);
  std::string bytes = "binary STL";  // not `solid`, with which a text would begin
  bytes.resize(80, ' ');
  append_little_endian(bytes, count);
  notes.emplace_back("STL has no vertices: those at the same place in single precision become one");
  note_losses(file, written_to_stl(), notes);
  return bytes + facets;
}

}  // namespace conformal
