// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/Graph_view.h>
#include <Conformal_geometry_processing/core/geometry_traits.h>
#include <Conformal_geometry_processing/core/named_parameters.h>
#include <Conformal_geometry_processing/core/write_points.h>
#include <Conformal_geometry_processing/spin/snap_to_class.h>

#include <string>

namespace Conformal_geometry_processing {

/// \ingroup PkgEntryPoints
/// \brief moves a surface, by as little as possible, to one that is discretely conformally
/// equivalent to a reference: to exactly its length cross-ratios, up to rounding.
///
/// Edge lengths then differ by factors at the vertices, l~_ij = l_ij exp((u_i + u_j) / 2)
/// [Springborn, Schroeder and Pinkall 2008]. To be used after any deformation that is nearly
/// conformal, such as a spin transformation, whose length cross-ratios are right up to the
/// discretization error. Any genus, with or without boundary, in one component or more.
///
/// Gauss-Newton steps of least change in the scale-invariant sense sum |df_j - df_i|^2 / |f_j -
/// f_i|^2. Typically one or two factorizations of a real symmetric matrix with blocks of 4 x 4
/// numbers on the vertices.
///
/// \tparam TriangleMesh see \ref triangle_mesh_requirements
/// \tparam PointMap a model of `ReadablePropertyMap` with the vertex descriptor as key
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh the surface; its points are overwritten
/// \param reference_points the points of the reference, which has the connectivity of the mesh
/// \param np optional named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{tolerance}
///     \cgalParamDescription{of the logarithms of length cross-ratios}
///     \cgalParamType{`double`}
///     \cgalParamDefault{1e-10}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_iterations}
///     \cgalParamDescription{maximum number of steps}
///     \cgalParamType{`unsigned int`}
///     \cgalParamDefault{40}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_point_map, output_vertex_point_map, geom_traits}
///     \cgalParamDescription{see `spin_transform()`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \returns the report, which converts to `true` if the surface is in the class. Otherwise nothing
/// has been written: the surface is too far from the class, or its scales from the precision of
/// its coordinates.
/// \throw Precondition_error if the mesh is not an oriented manifold triangle mesh with finite
/// coordinates, or an edge of the mesh or of the reference has length zero
/// \throw Solver_error if a factorization fails
template <class TriangleMesh, class PointMap,
          class NamedParameters = parameters::Default_named_parameters>
internal::Class_snap_report snap_to_conformal_class(
    TriangleMesh& mesh, PointMap reference_points,
    const NamedParameters& np = parameters::default_values())
{
  static_assert(
      internal::only_known_parameters<
          NamedParameters, CGAL::internal_np::vertex_point_t, CGAL::internal_np::geom_traits_t,
          CGAL::internal_np::number_of_iterations_t, internal_np::output_vertex_point_map_t,
          internal_np::tolerance_t>,
      "snap_to_conformal_class(): unknown named parameter, see the manual for those it accepts");
  const std::string function = "snap_to_conformal_class";
  const Graph_view<TriangleMesh> graph(mesh, np, function);
  const Graph_view<TriangleMesh> reference(mesh, reference_points,
                                           internal::geometry_traits<TriangleMesh>(np), function);
  internal::require_edge_lengths(graph.view(), function);
  internal::require_edge_lengths(reference.view(), function);
  internal::Snap_options options;
  double tolerance = 4 * options.tolerance;
  internal::read_parameter(np, internal_np::tolerance, tolerance);
  options.tolerance = tolerance / 4;
  internal::read_parameter(np, CGAL::internal_np::number_of_iterations, options.max_iterations);
  Points positions = graph.view().positions();
  const auto report = internal::snap_to_class(reference.view(), positions, options);
  if (report) internal::write_points(mesh, graph, positions, np);
  return report;
}

}  // namespace Conformal_geometry_processing
