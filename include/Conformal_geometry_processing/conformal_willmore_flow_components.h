// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_CONFORMAL_WILLMORE_FLOW_COMPONENTS_H
#define CONFORMAL_GEOMETRY_PROCESSING_CONFORMAL_WILLMORE_FLOW_COMPONENTS_H

#include <Conformal_geometry_processing/conformal_willmore_flow.h>
#include <Conformal_geometry_processing/core/for_each_component.h>
#include <Conformal_geometry_processing/mesh/requirements.h>

#include <string>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgEntryPoints
/// \brief does to each connected component of a mesh what `conformal_willmore_flow()` does to a
/// mesh of one.
///
/// Each component flows to the bit as it would in a mesh of its own, with time steps of its own,
/// until it arrives itself, and keeps its own area and centroid. Nothing keeps components from
/// running into each other.
///
/// \tparam TriangleMesh, NamedParameters as of `conformal_willmore_flow()`
/// \param mesh the surface, of any number of components; its points are overwritten
/// \param np optional named parameters: those of `conformal_willmore_flow()`; a visitor watches one
/// component after the other, and cancels all of them
///
/// \returns the reports in the order of the first vertices of the components, which tell why each
/// has stopped. They convert to `true` if all of them do. Whatever the reason, the points are those
/// of the last complete step of each: after a visitor has said no, the components that follow have
/// made none, stay where they were, and report `Flow_stop::cancelled` too.
/// \throw Precondition_error if the mesh is not an oriented manifold triangle mesh with finite
/// coordinates and positive areas, or a component or a parameter is refused
/// \throw Solver_error if an analysis fails
///
/// A component that is refused, or fails, does not keep the others from being tried, unless there
/// is no memory left; the message tells how many failed, and names the first ones for each reason.
/// Whatever is thrown, also by the visitor, the mesh is as it was.
template <class TriangleMesh, class NamedParameters = parameters::Default_named_parameters>
Component_reports<Flow_report> conformal_willmore_flow_components(
    TriangleMesh& mesh, const NamedParameters& np = parameters::default_values())
{
  const std::string function = "conformal_willmore_flow_components";
  const Graph_view<TriangleMesh> graph(mesh, np, function);
  require_manifold_components(graph.view(), function);
  require_positive_areas(graph.view(), function);
  Points positions = graph.view().positions();
  bool is_cancelled = false;
  auto reports = internal::for_each_component(
      graph, function,
      [&](const Graph_view<TriangleMesh>& component) {
        internal::Flow_result result{component.view().positions(), {}};
        result.report.stop = Flow_stop::cancelled;  // unless it is begun
        if (!is_cancelled) result = internal::flow_result(component, np, function);
        is_cancelled = result.report.stop == Flow_stop::cancelled;
        return result;
      },
      [&](const std::vector<int>& vertices, const internal::Flow_result& result) {
        positions(Eigen::indexing::all, vertices) = result.positions;
      });
  internal::write_points(mesh, graph, positions, np);
  return reports;
}

}  // namespace Conformal_geometry_processing

#endif
