// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/Graph_view.h>
#include <Conformal_geometry_processing/core/boundary_parameters.h>
#include <Conformal_geometry_processing/core/geometry_traits.h>
#include <Conformal_geometry_processing/core/named_parameters.h>
#include <Conformal_geometry_processing/core/spin_parameters.h>
#include <Conformal_geometry_processing/spin/Nearest_spin_transformation.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>

#include <CGAL/number_utils.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// the report of `nearest_spin_transform()`
struct [[nodiscard]] Nearest_spin_report : Spin_report {
  double distance = 0;                ///< see `Nearest_spin_result`
  double source_distance = 0;         ///< likewise that of the mesh
  double normal_distance = 0;         ///< see `Nearest_spin_result`
  double source_normal_distance = 0;  ///< likewise that of the mesh
  int sign_conflicts = 0;             ///< see `make_consistent()`; zero for smooth deformations
};

namespace internal {

/// The coordinates of the points in a vertex property map, 3 x |V|, by the traits of the mesh.
template <class TriangleMesh, class PointMap, class NamedParameters>
Points read_points(const TriangleMesh& mesh, PointMap points, const NamedParameters& np,
                   const char* function)
{
  return Graph_view<TriangleMesh>(mesh, points, geometry_traits<TriangleMesh>(np), function)
      .view()
      .positions();
}

}  // namespace internal

/// \ingroup PkgEntryPoints
/// \brief deforms a surface conformally, as closely as possible to a given deformation [CGP 5.9,
/// 6.3].
///
/// Minimises the mean square distance of the vertices, weighted by their areas, from the target
/// after the best similarity, as far as the normals come nearer with it: see `normal_weight`. The
/// result is never farther from the target than the mesh. This turns any editor into a conformal
/// one. Where the prescribed direction at a boundary leads to no such
/// surface, others are tried, see `Nearest_spin_transformation`.
///
/// \tparam TriangleMesh see \ref triangle_mesh_requirements
/// \tparam PointMap a model of `ReadablePropertyMap` with the vertex descriptor as key
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh the surface; its points are overwritten
/// \param target_points the position of each vertex after the deformation
/// \param np optional named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_scale_map}
///     \cgalParamDescription{factors by which lengths are scaled additionally}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptor as key and a
///                    positive number as value}
///     \cgalParamDefault{1}
///   \cgalParamNEnd
///   \cgalParamNBegin{blend}
///     \cgalParamDescription{t in (1 - t) lambda + t mu: 0 is conformal, 1 nearest to the target}
///     \cgalParamType{`double`}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
///   \cgalParamNBegin{fit}
///     \cgalParamDescription{what the search looks for and where it ends: `keep_curvature`,
///                           `normal_weight`, `shear`, `distance_tolerance`, `surface`. The other
///                           parameters take precedence}
///     \cgalParamType{`Nearest_spin_options`}
///     \cgalParamDefault{`Nearest_spin_options()`; with `vertex_scale_map` the curvature is kept}
///   \cgalParamNEnd
///   \cgalParamNBegin{scale_bound}
///     \cgalParamDescription{the largest factor by which lengths may change, see
///                           `spin_transform()`}
///     \cgalParamType{`double`, above 1, or `std::nullopt` for no bound}
///     \cgalParamDefault{none: the lengths are those of the target, as nearly as can be}
///   \cgalParamNEnd
///   \cgalParamNBegin{boundary_direction}
///     \cgalParamDescription{the direction of the boundary frame that is taken from the target}
///     \cgalParamType{`Boundary_direction`}
///     \cgalParamDefault{the tangent}
///   \cgalParamNEnd
///   \cgalParamNBegin{limits}
///     \cgalParamDescription{what counts as success, see `Spin_report::fault()`; the search comes
///                           as near to the target as they allow}
///     \cgalParamType{`Spin_report::Limits`}
///     \cgalParamDefault{`Spin_report::Limits()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{mollification}
///     \cgalParamDescription{admits faces of the mesh and of the target of any thinness, also of
///                           area zero, see `spin_transform()`}
///     \cgalParamType{`double`, between 0 and 1; 1e-6 is a good value}
///     \cgalParamDefault{none: faces of area zero are rejected}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_point_map, output_vertex_point_map, vertex_spin_map, exactness,
///                    geom_traits, sparse_solver, dirac, tolerance, number_of_iterations,
///                    random_seed, visitor}
///     \cgalParamDescription{see `spin_transform()`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \returns the report, which converts to `true` if the equation was solved. Otherwise nothing has
/// been written.
/// \throw Precondition_error if the mesh, or the target, is not a connected, oriented manifold
/// triangle mesh with finite coordinates and positive areas, or a factor is not positive, or the
/// target of a closed mesh has another spin structure, or a number of `fit` is negative
/// \throw Solver_error if a factorization fails
template <class TriangleMesh, class PointMap,
          class NamedParameters = parameters::Default_named_parameters>
Nearest_spin_report nearest_spin_transform(TriangleMesh& mesh, PointMap target_points,
                                           const NamedParameters& np = parameters::default_values())
{
  static_assert(
      internal::only_known_parameters<
          NamedParameters, CGAL::internal_np::vertex_point_t, CGAL::internal_np::geom_traits_t,
          CGAL::internal_np::number_of_iterations_t, CGAL::internal_np::random_seed_t,
          CGAL::internal_np::visitor_t, internal_np::output_vertex_point_map_t,
          internal_np::vertex_spin_map_t, internal_np::sparse_solver_t, internal_np::dirac_t,
          internal_np::tolerance_t, internal_np::vertex_scale_map_t, internal_np::blend_t,
          internal_np::fit_t, internal_np::scale_bound_t, internal_np::boundary_direction_t,
          internal_np::exactness_t, internal_np::limits_t, internal_np::mollification_t>,
      "nearest_spin_transform(): unknown named parameter, see the manual for those it accepts");
  const char* const function = "nearest_spin_transform";
  const Graph_view<TriangleMesh> graph(mesh, np, function);
  Nearest_spin_options options =
      internal::parameter_or(np, internal_np::fit, Nearest_spin_options());
  if constexpr (internal::has_parameter<NamedParameters, internal_np::boundary_direction_t>) {
    const Boundary_direction d =
        CGAL::parameters::get_parameter(np, internal_np::boundary_direction);
    options.direction = {d.tangent, d.normal, d.binormal};
  }
  internal::read_request(np, options.surface);
  internal::read_parameter(np, internal_np::scale_bound, options.surface.scales.bound);
  Nearest_spin_transformation nearest(
      graph.view(), internal::read_points(mesh, target_points, np, function), function, options);
  if constexpr (internal::has_parameter<NamedParameters, internal_np::vertex_scale_map_t>) {
    const auto scales = CGAL::parameters::get_parameter(np, internal_np::vertex_scale_map);
    nearest.scale_lengths(internal::read_vertex_numbers(graph, scales));
  }
  Spin_visitor silent;
  auto&& visitor = internal::parameter_or(np, CGAL::internal_np::visitor, silent);
  Nearest_spin_result result = nearest.transform(internal::asking(visitor));
  double t = 0;
  internal::read_parameter(np, internal_np::blend, t);
  if (t != 0 && result.report) result = nearest.blend(result, t);
  if (result.report) internal::write_spin_result(mesh, graph, result, np);
  Nearest_spin_report report;
  static_cast<Spin_report&>(report) = result.report;
  report.distance = result.distance;
  report.source_distance = result.source_distance;
  report.normal_distance = result.normal_distance;
  report.source_normal_distance = result.source_normal_distance;
  report.sign_conflicts = nearest.sign_conflicts();
  return report;
}

}  // namespace Conformal_geometry_processing
