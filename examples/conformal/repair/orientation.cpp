// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "orientation.h"

#include "conformal/io/data/texture_coordinates.h"
#include "conformal/process/at.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace conformal {
namespace {

using Conformal_geometry_processing::Mesh_view;

// The halfedges of a triangle in an order that is the same when it is turned around.
std::array<int, 3> sides(const Mesh_view& mesh, int f)
{
  std::array<int, 3> h = {3 * f, 3 * f + 1, 3 * f + 2};
  std::sort(h.begin(), h.end(), [&](int i, int j) { return mesh.edge(i) < mesh.edge(j); });
  return h;
}

// Walks over a component from its first triangle, which is not turned, and decides about all
// others. Returns the triangles of the component; clears `is_orientable` at a contradiction.
std::vector<int> walk(const Mesh_view& mesh, int first, std::vector<signed char>& turned,
                      bool& is_orientable)
{
  std::vector<int> component = {first};
  turned[at(first)] = 0;
  for (std::size_t i = 0; i < component.size(); ++i)
    for (const int h : sides(mesh, component[i])) {
      const int g = mesh.twin(h);
      if (g < 0) continue;
      const bool conflict = mesh.from(g) == mesh.from(h);
      const auto wanted = static_cast<signed char>(turned[at(component[i])] ^ (conflict ? 1 : 0));
      signed char& present = turned[at(Mesh_view::face(g))];
      if (present < 0) {
        present = wanted;
        component.push_back(Mesh_view::face(g));
      } else if (present != wanted) {
        is_orientable = false;
      }
    }
  return component;
}

void reverse_corners(std::vector<int>& corners, const Polygons& polygons, std::size_t f)
{
  if (corners.empty()) return;
  std::reverse(corners.begin() + static_cast<std::ptrdiff_t>(polygons.first[f]),
               corners.begin() + static_cast<std::ptrdiff_t>(polygons.first[f + 1]));
}

}  // namespace

Orientation find_orientation(const Mesh_view& mesh, const std::vector<int>& face_in_file,
                             std::size_t size)
{
  Orientation o;
  o.is_turned.assign(size, 0);
  std::vector<signed char> turned(at(mesh.size_of_faces()), -1);
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    if (turned[at(f)] >= 0) continue;
    const std::vector<int> component = walk(mesh, f, turned, o.is_orientable);
    const auto count = std::count_if(component.begin(), component.end(),
                                     [&](int g) { return turned[at(g)] == 1; });
    const bool most_are_turned = 2 * static_cast<std::size_t>(count) > component.size();
    for (const int g : component)
      o.is_turned[at(face_in_file[at(g)])] = (turned[at(g)] == 1) != most_are_turned;
  }
  return o;
}

void turn_faces(Surface_file& file, const std::vector<char>& is_turned)
{
  list_to_corners(file);
  for (std::size_t f = 0; f < is_turned.size(); ++f) {
    if (!is_turned[f]) continue;
    reverse_corners(file.polygons.corners, file.polygons, f);
    reverse_corners(file.texture.index, file.polygons, f);
    reverse_corners(file.normals.index, file.polygons, f);
  }
}

}  // namespace conformal
