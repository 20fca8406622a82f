// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "cut_open.h"

#include "cut_graph.h"

#include "conformal/process/Failure.h"
#include "conformal/repair/separate_fans.h"

#include <Conformal_geometry_processing/mesh/Mesh_component.h>
#include <Conformal_geometry_processing/mesh/topology.h>

#include <algorithm>
#include <string>
#include <utility>

namespace conformal {
namespace {

using CGP::internal::Mesh_component;

int vertex_in_file(const Surface_input& input, const Mesh_component& component, int v)
{
  const auto in_mesh = static_cast<std::size_t>(component.vertices[static_cast<std::size_t>(v)]);
  return input.vertex_in_file[in_mesh];
}

/// All edges but the diagonals of polygons
Edge_set edges_of_file(const Surface_input& input, const Mesh_component& component)
{
  const auto polygon = [&](int h) {
    const int f = component.faces[static_cast<std::size_t>(CGP::Mesh_view::face(h))];
    return input.face_in_file[static_cast<std::size_t>(f)];
  };
  Edge_set edges;
  for (int k = 0; k < component.mesh.size_of_edges(); ++k) {
    const int h = *component.mesh.halfedges_begin(k);
    edges.push_back(polygon(h) != polygon(component.mesh.twin(h)));
  }
  return edges;
}

/// the given cones that lie on the component, or else its tips
std::vector<int> ends_of_cut(const Surface_input& input, const Mesh_component& component,
                             const Cut_options& options, const Edge_set& ways)
{
  if (options.cones.empty()) return find_tips(component.mesh, std::max(options.tips, 2), ways);
  std::vector<int> found;
  for (int v = 0; v < component.mesh.size_of_vertices(); ++v) {
    const int i = vertex_in_file(input, component, v);
    if (std::find(options.cones.begin(), options.cones.end(), i) != options.cones.end())
      found.push_back(v);
  }
  const bool is_sphere = CGP::topology(component.mesh).is_sphere();
  if (found.empty() || (is_sphere && found.size() < 2))
    throw unsuitable(input.file.path,
                     "--cones wants vertices of each closed component, two at least of a sphere; "
                     "try: --cut, which finds them");
  return found;
}

void add_cut(const Surface_input& input, const Mesh_component& component,
             const Cut_options& options, std::vector<Corner_fans::Edge>& cuts)
{
  const Edge_set ways = edges_of_file(input, component);
  const Edge_set cut =
      cut_graph(component.mesh, ends_of_cut(input, component, options, ways), ways);
  for (int k = 0; k < component.mesh.size_of_edges(); ++k) {
    if (!cut[static_cast<std::size_t>(k)]) continue;
    const auto& ends = component.mesh.ends(k);
    const auto [a, b] = std::minmax(
        {vertex_in_file(input, component, ends[0]), vertex_in_file(input, component, ends[1])});
    cuts.push_back({a, b});
  }
}

}  // namespace

Cut_surface cut_open(const Surface_input& input, const Cut_options& options)
{
  std::vector<Corner_fans::Edge> cuts;
  for (const Mesh_component& component : CGP::mesh_components(input.mesh))
    if (CGP::topology(component.mesh).is_closed()) add_cut(input, component, options, cuts);
  std::sort(cuts.begin(), cuts.end());
  Surface_file file = input.file;
  const Corner_fans fans(file.polygons, cuts);
  std::vector<int> origin = separate_fans(file, fans).vertex_in_file;
  return {prepare(std::move(file)), std::move(origin)};
}

}  // namespace conformal
