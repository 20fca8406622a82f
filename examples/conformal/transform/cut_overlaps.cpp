// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "cut_overlaps.h"

#include "conformal/process/at.h"

#include <Conformal_geometry_processing/measure/overlaps.h>
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/parameterization/place_in_plane.h>

#include <algorithm>
#include <utility>

namespace conformal {
namespace {

/// The edges of the file between faces of different charts
std::vector<Corner_fans::Edge> edges_between(const std::vector<int>& charts,
                                             const Surface_input& input)
{
  std::vector<Corner_fans::Edge> edges;
  for (int h = 0; h < input.mesh.size_of_halfedges(); ++h) {
    const int t = input.mesh.twin(h), f = CGP::Mesh_view::face(h);
    if (t < h) continue;  // also at the boundary
    const int g = CGP::Mesh_view::face(t);
    if (charts[at(f)] == charts[at(g)] || input.face_in_file[at(f)] == input.face_in_file[at(g)])
      continue;
    const auto [a, b] = std::minmax(input.vertex_in_file[at(input.mesh.from(h))],
                                    input.vertex_in_file[at(input.mesh.to(h))]);
    edges.push_back({a, b});
  }
  return edges;
}

/// What is known of copies, from what was known of the vertices before
Flat_components at_copies(const Flat_components& flat, const Surface_input& before,
                          const Cut_surface& after)
{
  std::vector<int> in_mesh(before.file.points.size(), -1), from;
  for (int v = 0; v < before.mesh.size_of_vertices(); ++v)
    in_mesh[at(before.vertex_in_file[at(v)])] = v;
  Flat_components copies;
  for (const int copy : after.input.vertex_in_file) {
    from.push_back(in_mesh[at(after.origin[at(copy)])]);
    copies.has_image.push_back(flat.has_image[at(from.back())]);
  }
  copies.positions = flat.positions(Eigen::indexing::all, from);
  return copies;
}

}  // namespace

void place_apart(const CGP::Mesh_view& mesh, CGP::Points& positions)
{
  Eigen::VectorXcd z(positions.cols());
  z.real() = positions.row(0).transpose();
  z.imag() = positions.row(1).transpose();
  CGP::place_side_by_side(CGP::connected_components(mesh), z);
  positions.topRows<2>() = CGP::in_space(z).topRows<2>();
}

int cut_overlaps(Cut_surface& surface, Flat_components& flat)
{
  const auto pairs = CGP::internal::overlaps(surface.input.mesh, flat.positions);
  if (pairs.empty()) return 0;
  const auto charts = CGP::internal::charts_without(pairs, surface.input.mesh);
  Cut_surface parts = cut_along(surface.input.file, edges_between(charts, surface.input));
  flat = at_copies(flat, surface.input, parts);
  place_apart(parts.input.mesh, flat.positions);
  for (int& origin : parts.origin) origin = surface.origin[at(origin)];
  parts.cones = std::move(surface.cones);
  surface = std::move(parts);
  const std::vector<int> components = CGP::connected_components(surface.input.mesh);
  return 1 + *std::max_element(components.begin(), components.end());
}

}  // namespace conformal
