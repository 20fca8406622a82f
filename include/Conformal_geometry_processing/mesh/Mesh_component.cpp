// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/Mesh_component.h>

#include <Conformal_geometry_processing/mesh/topology.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {

std::vector<internal::Mesh_component> mesh_components(const Mesh_view& mesh)
{
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  const std::vector<int> component = connected_components(mesh);
  int count = 0;
  for (const int c : component) count = (std::max)(count, c + 1);
  std::vector<internal::Mesh_component> parts(at(count));
  std::vector<Mesh_view::Corners> corners(at(count));
  std::vector<int> number(component.size());  // in its component
  for (int v = 0; v < mesh.size_of_vertices(); ++v) {
    std::vector<int>& vertices = parts[at(component[at(v)])].vertices;
    number[at(v)] = static_cast<int>(vertices.size());
    vertices.push_back(v);
  }
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const std::array<int, 3>& v = mesh.corners(f);
    const std::size_t c = at(component[at(v[0])]);
    parts[c].faces.push_back(f);
    corners[c].push_back({number[at(v[0])], number[at(v[1])], number[at(v[2])]});
  }
  for (std::size_t c = 0; c < parts.size(); ++c)
    parts[c].mesh =
        Mesh_view(mesh.positions()(Eigen::indexing::all, parts[c].vertices), std::move(corners[c]));
  return parts;
}

internal::Mesh_component internal::selected_faces(const Mesh_view& mesh,
                                                  const std::vector<char>& is_selected)
{
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  Mesh_component part;
  std::vector<int> number(at(mesh.size_of_vertices()), -1);  // in the part
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    if (!is_selected[at(f)]) continue;
    part.faces.push_back(f);
    for (const int v : mesh.corners(f)) number[at(v)] = 0;
  }
  for (int v = 0; v < mesh.size_of_vertices(); ++v) {
    if (number[at(v)] < 0) continue;
    number[at(v)] = static_cast<int>(part.vertices.size());
    part.vertices.push_back(v);
  }
  Mesh_view::Corners corners;
  for (const int f : part.faces) {
    const std::array<int, 3>& v = mesh.corners(f);
    corners.push_back({number[at(v[0])], number[at(v[1])], number[at(v[2])]});
  }
  part.mesh = Mesh_view(mesh.positions()(Eigen::indexing::all, part.vertices), std::move(corners));
  return part;
}

}  // namespace Conformal_geometry_processing
