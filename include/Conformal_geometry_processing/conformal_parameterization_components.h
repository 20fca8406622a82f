// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/conformal_parameterization.h>
#include <Conformal_geometry_processing/core/for_each_component.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/parameterization/place_in_plane.h>

#include <string>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgEntryPoints
/// \brief Flattens each connected component of a mesh by `conformal_parameterization()`, and places
/// the images side by side.
///
/// Each image has the same shape and size as for the component alone. Bounding boxes of images do
/// not overlap, and lie above and to the right of the origin (`place_side_by_side()`).
///
/// \tparam TriangleMesh, VertexUVMap, NamedParameters as for `conformal_parameterization()`
/// \param mesh the surface, of any number of components, with a boundary each
/// \param uv_map receives the point of each vertex
/// \param np optional named parameters: those of `conformal_parameterization()`
///
/// \returns the reports in the order of the first vertices of the components. They convert to
/// `true` if all maps were found; otherwise nothing is written.
/// \throw Precondition_error if the mesh is not an oriented manifold triangle mesh with finite
/// coordinates and positive areas, or a component is closed
/// \throw Solver_error if an energy cannot be factorized
///
/// If a component is rejected or fails, the others are still tried, unless memory is exhausted; the
/// message contains the number of failed components, and names the first ones for each reason.
template <class TriangleMesh, class VertexUVMap,
          class NamedParameters = parameters::Default_named_parameters>
internal::Component_reports<Parameterization_report> conformal_parameterization_components(
    const TriangleMesh& mesh, VertexUVMap uv_map,
    const NamedParameters& np = parameters::default_values())
{
  const std::string function = "conformal_parameterization_components";
  const Graph_view<TriangleMesh> graph(mesh, np, function);
  require_manifold_components(graph.view(), function);
  require_positive_areas(graph.view(), function);
  Eigen::VectorXcd z(graph.view().size_of_vertices());
  auto reports = internal::for_each_component(
      graph, function,
      [&](const Graph_view<TriangleMesh>& component) {
        return internal::parameterization_result(component, np, function);
      },
      [&](const std::vector<int>& vertices, const internal::Parameterization_result& result) {
        z(vertices) = result.z;
      });
  if (!reports) return reports;
  place_side_by_side(connected_components(graph.view()), z);
  internal::write_plane_points(graph, z, uv_map);
  return reports;
}

}  // namespace Conformal_geometry_processing
