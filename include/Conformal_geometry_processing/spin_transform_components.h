// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/for_each_component.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Conformal_geometry_processing/spin_transform.h>

#include <string>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgEntryPoints
/// \brief Applies `spin_transform()` to each connected component of a mesh: to all of them, or
/// none.
///
/// The Dirac matrix of several components is block diagonal, and each block has its own eigenvector
/// and eigenvalue gamma: each component has one eigenproblem, one factorization and one report, and
/// the factors take the memory of the largest one. Each component is transformed bitwise as in a
/// separate mesh, by the same rules: constants in rho have no effect; each component preserves its
/// area, its centroid and its mean direction, and thus its relative position; components with
/// handles take their own number of steps; boundary conditions are rejected if a component has no
/// boundary. Intersections of components are not prevented.
///
/// \tparam TriangleMesh, CurvaturePotentialMap, NamedParameters as for `spin_transform()`
/// \param mesh the surface, of any number of components; its points are overwritten
/// \param rho the change of mean curvature, in 1/length of the mesh
/// \param np optional named parameters: those of `spin_transform()`; a visitor observes one
/// component after the other, and cancels all of them
///
/// \returns the reports in the order of the first vertices of the components. They convert to
/// `true` if the equations of all were solved; otherwise nothing is written.
/// \throw Precondition_error if the mesh is not an oriented manifold triangle mesh with finite
/// coordinates and, without `mollification`, positive areas; if rho is not finite; or if a
/// component is rejected: because the boundary conditions do not fit it, because `mollification` is
/// not above 0 and below 1, or all its faces have area zero with it
/// \throw Solver_error if a factorization fails
///
/// If a component is rejected or fails, the others are still tried, unless memory is exhausted; the
/// message contains the number of failed components, and names the first ones for each reason. If
/// an exception is thrown, the mesh is unchanged.
template <class TriangleMesh, class CurvaturePotentialMap,
          class NamedParameters = parameters::Default_named_parameters>
internal::Component_reports<Spin_report> spin_transform_components(
    TriangleMesh& mesh, CurvaturePotentialMap rho,
    const NamedParameters& np = parameters::default_values())
{
  const std::string function = "spin_transform_components";
  const Graph_view<TriangleMesh> graph(mesh, np, function);
  require_manifold_components(graph.view(), function);
  if constexpr (!internal::has_parameter<NamedParameters, internal_np::mollification_t>)
    require_positive_areas(graph.view(), function);
  require_potential(graph.view(), internal::read_curvature_potential(graph, rho), 1, function);
  Spin_result all;
  all.positions = graph.view().positions();
  all.lambda.resize(graph.view().size_of_vertices());
  bool is_cancelled = false;
  Spin_visitor silent;
  auto&& visitor = internal::parameter_or(np, CGAL::internal_np::visitor, silent);
  const auto transformed = [&](const Graph_view<TriangleMesh>& component) {
    return Spin_transformation(component.view(),
                               internal::spin_transformation_options(component, np, function),
                               function)
        .transform(internal::read_curvature_potential(component, rho), internal::asking(visitor));
  };
  const auto reports = internal::for_each_component(
      graph, function,
      [&](const Graph_view<TriangleMesh>& component) {
        Spin_result result;
        result.report.cancelled = is_cancelled;  // applies to all remaining components
        if (!is_cancelled) result = transformed(component);
        is_cancelled = result.report.cancelled;
        return result;
      },
      [&](const std::vector<int>& vertices, const Spin_result& result) {
        if (!result.report) return;
        all.positions(Eigen::indexing::all, vertices) = result.positions;
        all.lambda(vertices) = result.lambda;
      });
  if (reports) internal::write_spin_result(mesh, graph, all, np);
  return reports;
}

}  // namespace Conformal_geometry_processing
