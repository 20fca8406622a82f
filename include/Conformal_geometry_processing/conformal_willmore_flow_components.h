// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/conformal_willmore_flow.h>
#include <Conformal_geometry_processing/core/for_each_component.h>
#include <Conformal_geometry_processing/mesh/requirements.h>

#include <string>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgEntryPoints
/// \brief Applies `conformal_willmore_flow()` to each connected component of a mesh.
///
/// Each component flows bitwise as in a separate mesh, with its own time steps, until it converges,
/// and preserves its area and centroid. Intersections of components are not prevented.
///
/// \tparam TriangleMesh, NamedParameters as for `conformal_willmore_flow()`
/// \param mesh the surface, of any number of components; its points are overwritten
/// \param np optional named parameters: those of `conformal_willmore_flow()`; a visitor observes
/// one component after the other, and cancels all of them
///
/// \returns the reports in the order of the first vertices of the components, with the reason why
/// each has stopped. They convert to `true` if all of them do. In any case, the points are those
/// of the last complete step of each: after cancellation by a visitor, the remaining components are
/// unchanged, and also report `Flow_step_report::Stop::cancelled`.
/// \throw Precondition_error if the mesh is not an oriented manifold triangle mesh with finite
/// coordinates and positive areas, or a component or a parameter is rejected
/// \throw Solver_error if an analysis fails
///
/// If a component is rejected or fails, the others are still tried, unless memory is exhausted; the
/// message contains the number of failed components, and names the first ones for each reason. If
/// an exception is thrown, also by the visitor, the mesh is unchanged.
template <class TriangleMesh, class NamedParameters = parameters::Default_named_parameters>
internal::Component_reports<Flow_report> conformal_willmore_flow_components(
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
        result.report.stop = Flow_step_report::Stop::cancelled;  // unless the flow is started
        if (!is_cancelled) result = internal::flow_result(component, np, function);
        is_cancelled = result.report.stop == Flow_step_report::Stop::cancelled;
        return result;
      },
      [&](const std::vector<int>& vertices, const internal::Flow_result& result) {
        positions(Eigen::indexing::all, vertices) = result.positions;
      });
  internal::write_points(mesh, graph, positions, np);
  return reports;
}

}  // namespace Conformal_geometry_processing
