// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Component.h"

#include <Conformal_geometry_processing/mesh/Boundary_frames.h>

namespace conformal {
namespace {

/// Numbers the boundary vertices of the component among those of the whole surface.
std::vector<int> boundary_on_component(const CGP::Mesh_view& whole, const Component& component)
{
  const std::vector<int> all = CGP::boundary_frames(whole).vertices;
  std::vector<int> number(static_cast<std::size_t>(whole.size_of_vertices()), -1), columns;
  for (std::size_t k = 0; k < all.size(); ++k)
    number[static_cast<std::size_t>(all[k])] = static_cast<int>(k);
  for (const int v : CGP::boundary_frames(component.input.mesh).vertices) {
    const int in_whole = component.vertices[static_cast<std::size_t>(v)];
    columns.push_back(number[static_cast<std::size_t>(in_whole)]);
  }
  return columns;
}

}  // namespace

CGP::Curvature_potential on_component(const CGP::Curvature_potential& rho,
                                      const Component& component, double factor)
{
  const bool on_faces = rho.on == CGP::Curvature_potential::On::faces;
  return {rho.on, factor * rho.values(on_faces ? component.faces : component.vertices)};
}

CGP::Boundary_condition on_component(const CGP::Boundary_condition& condition,
                                     const CGP::Mesh_view& whole, const Component& component)
{
  CGP::Boundary_condition own = condition;
  if (condition.targets.cols() == 0) return own;
  const std::vector<int> columns = boundary_on_component(whole, component);
  own.targets = condition.targets(Eigen::indexing::all, columns);
  if (condition.normals.cols() > 0) own.normals = condition.normals(Eigen::indexing::all, columns);
  return own;
}

CGP::Mesh_view on_component(const CGP::Mesh_view& other, const Component& component)
{
  CGP::Mesh_view own = component.input.mesh;
  own.set_positions(other.positions()(Eigen::indexing::all, component.vertices));
  return own;
}

}  // namespace conformal
