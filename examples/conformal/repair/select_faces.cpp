// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "select_faces.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

namespace conformal {
namespace {

/// \brief The element with the given rows only, in this order, bit for bit; a row may come twice.
Element selected_rows(const Element& element, const std::vector<int>& rows)
{
  Element result{element.name, rows.size(), {}};
  for (const Property& all : element.properties) {
    Property some = all.is_list() ? Property(all.name(), all.count_type(), all.type())
                                  : Property(all.name(), all.type());
    for (const int r : rows) {
      const auto row = static_cast<std::size_t>(r);
      for (std::size_t i = 0; i < all.count(row); ++i)
        some.append_bytes(all.bytes(all.first(row) + i), false);
      if (all.is_list()) some.end_list();
    }
    result.properties.push_back(std::move(some));
  }
  return result;
}

}  // namespace

void append(Selected_faces& faces, const Surface_file& file, int face_in_file,
            const std::vector<std::size_t>& corners)
{
  for (const std::size_t c : corners) {
    faces.polygons.corners.push_back(file.polygons.corners[c]);
    if (!file.texture.index.empty()) faces.texture.push_back(file.texture.index[c]);
    if (!file.normals.index.empty()) faces.normals.push_back(file.normals.index[c]);
  }
  faces.polygons.first.push_back(faces.polygons.corners.size());
  faces.face_in_file.push_back(face_in_file);
}

void select_faces(Surface_file& file, Selected_faces faces)
{
  const std::vector<int>& origin = faces.face_in_file;
  for (Group_line& line : file.group_lines)
    line.face = static_cast<std::size_t>(
        std::lower_bound(origin.begin(), origin.end(), static_cast<int>(line.face)) -
        origin.begin());
  file.polygons = std::move(faces.polygons);
  if (!file.texture.index.empty()) file.texture.index = std::move(faces.texture);
  if (!file.normals.index.empty()) file.normals.index = std::move(faces.normals);
  file.faces = selected_rows(file.faces, origin);
}

void select_vertices(Surface_file& file, const std::vector<int>& kept)
{
  std::vector<Point> points;
  for (const int v : kept) points.push_back(file.points[static_cast<std::size_t>(v)]);
  file.points = std::move(points);
  file.vertices = selected_rows(file.vertices, kept);
}

std::vector<int> vertices_of(const Surface_file& file, const std::vector<int>& faces)
{
  const Polygons& polygons = file.polygons;
  std::vector<int> vertices;
  for (const int f : faces) {
    const auto first = polygons.corners.begin() +
                       static_cast<std::ptrdiff_t>(polygons.first[static_cast<std::size_t>(f)]);
    const auto degree = polygons.degree(static_cast<std::size_t>(f));
    vertices.insert(vertices.end(), first, first + static_cast<std::ptrdiff_t>(degree));
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

Surface_file part_of(const Surface_file& file, const std::vector<int>& faces)
{
  Selected_faces selected;
  for (const int f : faces) {
    const auto at = static_cast<std::size_t>(f);
    std::vector<std::size_t> corners(file.polygons.degree(at));
    std::iota(corners.begin(), corners.end(), file.polygons.first[at]);
    append(selected, file, f, corners);
  }
  const std::vector<int> vertices = vertices_of(file, faces);
  for (int& v : selected.polygons.corners)
    v = static_cast<int>(std::lower_bound(vertices.begin(), vertices.end(), v) - vertices.begin());
  Surface_file part = file;
  part.other_elements.clear();  // they refer to vertices by their numbers in the whole
  select_faces(part, std::move(selected));
  select_vertices(part, vertices);
  return part;
}

}  // namespace conformal
