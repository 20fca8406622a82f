// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/Graph_view.h>
#include <Conformal_geometry_processing/core/boundary_parameters.h>
#include <Conformal_geometry_processing/core/named_parameters.h>
#include <Conformal_geometry_processing/core/spin_parameters.h>
#include <Conformal_geometry_processing/surfaces/minimal_surface.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgEntryPoints
/// \brief Deforms a surface with boundary conformally into a minimal surface, by rho = -H in one
/// solve [CGP 6.5.3].
///
/// Its shape is determined by the directions at its boundary: by default its tangents are
/// preserved. For a flat mesh, tangents in its plane yield its conformal maps to other plane
/// domains. With binormals there is a surface for each eigenvalue gamma of D - rho, of mean
/// curvature gamma / |lambda|^2; only gamma = 0 up to the discretisation error counts, and the
/// report is false where no eigenvalue is.
///
/// \tparam TriangleMesh see \ref triangle_mesh_requirements
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh the surface; its points are overwritten
/// \param np optional named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{boundary_direction}
///     \cgalParamDescription{the direction in the boundary frame that is preserved or prescribed}
///     \cgalParamType{`Boundary_direction`, not the normal}
///     \cgalParamDefault{the tangent}
///   \cgalParamNEnd
///   \cgalParamNBegin{boundary_direction_map}
///     \cgalParamDescription{the prescribed direction, for each vertex on the boundary}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptor as key and a
///                    vector, not zero, as value}
///     \cgalParamDefault{the direction before}
///   \cgalParamNEnd
///   \cgalParamNBegin{dirac}
///     \cgalParamDescription{see `spin_transform()`; where its `kernel_tolerance` is zero, that is
///                           `minimal_kernel_tolerance()`}
///     \cgalParamType{`Dirac_options`}
///     \cgalParamDefault{`Dirac_options()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_point_map, output_vertex_point_map, vertex_spin_map, geom_traits,
///                    sparse_solver, tolerance, number_of_iterations, random_seed}
///     \cgalParamDescription{see `spin_transform()`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \returns the report, which converts to `true` if such a surface exists. Otherwise nothing is
/// written, and `reached` is the share of the way to it that exists: steps of
/// `conformal_willmore_flow()` with the same `boundary_direction` may go all of it, and a second
/// call then finds the minimal surface.
/// \throw Precondition_error if the mesh is not a connected, oriented manifold triangle mesh with
/// boundary, finite coordinates and positive areas, or the directions do not fit it
/// \throw Solver_error if a factorization fails
template <class TriangleMesh, class NamedParameters = parameters::Default_named_parameters>
Spin_report minimal_surface(TriangleMesh& mesh,
                            const NamedParameters& np = parameters::default_values())
{
  static_assert(
      internal::only_known_parameters<
          NamedParameters, CGAL::internal_np::vertex_point_t, CGAL::internal_np::geom_traits_t,
          CGAL::internal_np::number_of_iterations_t, CGAL::internal_np::random_seed_t,
          internal_np::output_vertex_point_map_t, internal_np::vertex_spin_map_t,
          internal_np::sparse_solver_t, internal_np::tolerance_t, internal_np::dirac_t,
          internal_np::boundary_direction_t, internal_np::boundary_direction_map_t>,
      "minimal_surface(): unknown named parameter, see the manual for those it accepts");
  const Graph_view<TriangleMesh> graph(mesh, np, "minimal_surface");
  Boundary_condition condition = internal::boundary_condition(graph, np, "minimal_surface");
  if (condition.kind == Boundary_condition::Kind::free) condition = Boundary_condition::tangents();
  Spin_transformation_options own;
  own.boundary = condition;
  own.solvers = internal::spin_solvers(np);
  internal::read_dirac_options(np, own.dirac);
  const Spin_result result = spin_to_minimal_surface(graph.view(), own, "minimal_surface");
  if (result.report) internal::write_spin_result(mesh, graph, result, np);
  return result.report;
}

}  // namespace Conformal_geometry_processing
