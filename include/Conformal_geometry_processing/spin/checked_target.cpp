// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/checked_target.h>

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/spin/Framed_surface.h>
#include <Conformal_geometry_processing/spin/spin_structure.h>

namespace Conformal_geometry_processing::internal {

std::pair<Mesh_view, Points> in_frame(const Mesh_view& mesh, const Points& target)
{
  const Normalized_frame frame(mesh.positions());
  std::pair<Mesh_view, Points> both{mesh, frame.to_frame(target)};
  both.first.set_positions(frame.to_frame(mesh.positions()));
  return both;
}

Points checked_target(const Mesh_view& mesh, Points target,
                      const std::optional<double>& mollification, const std::string& function)
{
  Framed_surface::require(mesh, mollification, function);
  if (target.cols() != mesh.size_of_vertices())
    throw Precondition_error(function, std::to_string(target.cols()) +
                                           " target positions, one per vertex is needed: " +
                                           std::to_string(mesh.size_of_vertices()));
  Framed_surface::require_faces(Mesh_view(target, mesh.corners()), mollification.has_value(),
                                function + ", target");
  const auto [before, after] = in_frame(mesh, target);
  if (boundary_loops(mesh).empty() && !mollification)
    require_same_spin_structure(before, after, function);
  return target;
}

}  // namespace Conformal_geometry_processing::internal
