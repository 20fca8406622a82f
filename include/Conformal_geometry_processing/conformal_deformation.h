// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/Graph_view.h>
#include <Conformal_geometry_processing/core/geometry_traits.h>
#include <Conformal_geometry_processing/core/named_parameters.h>
#include <Conformal_geometry_processing/core/spin_parameters.h>
#include <Conformal_geometry_processing/spin/Conformal_deformation.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>

namespace Conformal_geometry_processing {
namespace internal {

template <class TriangleMesh, class NamedParameters>
Conformal_deformation_options conformal_deformation_options(const Graph_view<TriangleMesh>& graph,
                                                            const NamedParameters& np)
{
  static_assert(
      only_known_parameters<
          NamedParameters, CGAL::internal_np::vertex_point_t, CGAL::internal_np::geom_traits_t,
          CGAL::internal_np::visitor_t, internal_np::output_vertex_point_map_t,
          internal_np::vertex_spin_map_t, internal_np::sparse_solver_t, internal_np::exactness_t,
          internal_np::limits_t, internal_np::position_weight_t, internal_np::mollification_t,
          internal_np::scale_bound_t, internal_np::vertex_scale_map_t,
          internal_np::vertex_scale_weight_map_t, internal_np::vertex_region_map_t>,
      "conformal_deformation(): unknown named parameter, see the manual for those it accepts");
  Conformal_deformation_options options;
  read_exactness_and_mollification(np, options.surface);
  read_scale_control(graph, np, options.surface);
  read_parameter(np, internal_np::position_weight, options.position_weight);
  if constexpr (has_parameter<NamedParameters, internal_np::vertex_region_map_t>)
    options.region = read_vertex_numbers(
        graph, CGAL::parameters::get_parameter(np, internal_np::vertex_region_map));
  return options;
}

}  // namespace internal

/// \ingroup PkgEntryPoints
/// \brief deforms a surface conformally so that given vertices, or regions, move to given places.
///
/// Finds the least change rho of mean curvature, and spins that nearly solve its Dirac equation
/// [CGP (5.3)-(5.5)], whose surface, placed by a similarity, has the vertices at their targets:
/// angles are preserved up to the discretisation error, and so are textures and the shapes of small
/// details. All vertices may move and scale. The targets are met exactly, up to about 1e-9 of the
/// size of the mesh, unless there is a `position_weight`.
///
/// What similarities can do costs nothing: one or two targets, or targets that are the image of the
/// vertices under a similarity, move, turn and scale the whole surface. Fix parts by targets where
/// they are. On a surface of genus > 0 the edges stay closed around handles; a boundary is free.
///
/// With a `vertex_region_map`, the cost is that of the region alone, and the report tells how
/// conformal its `collar` is; the other measures are those of the faces that may move.
///
/// Targets can be beyond what a conformal map of this mesh can reach. They are approached in steps
/// along straight lines; where the next surface does not verify, or has flipped faces, the way
/// ends. The report tells the share that was reached (`reached`), and is `false` unless this is 1;
/// allow less by `limits`, with `Spin_report::Limits::realised_share`.
///
/// That costs one or two factorizations of the sparse quaternionic matrix on the vertices, far
/// moves up to ten, some 100 to 400 solves with it for each, and one solve for each target in each
/// step.
///
/// \tparam TriangleMesh see \ref triangle_mesh_requirements
/// \tparam TargetRange a range of pairs: of a vertex descriptor and a point; or of a range of
/// vertex descriptors and a motion of the region, a `CGAL::Aff_transformation_3` \tparam
/// NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh the surface, oriented with normals outward; its points are overwritten
/// \param targets the new positions of vertices. A region follows its motion in the mean: its
/// centre and the ends of its axes of inertia do
/// \param np optional named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map, output_vertex_point_map, geom_traits, vertex_scale_map,
///                    vertex_scale_weight_map, exactness, mollification, sparse_solver, visitor}
///     \cgalParamDescription{see `spin_transform()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_spin_map}
///     \cgalParamDescription{receives lambda, with the turn and the scale of the similarity}
///     \cgalParamType{a model of `WritablePropertyMap`; its value is any type that
///                    `Quaternion_access` knows}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{position_weight}
///     \cgalParamDescription{weight of the distances from the targets against rho, in multiples of
///                           1 / R with R the radius of the sphere of the same area}
///     \cgalParamType{a positive number}
///     \cgalParamDefault{infinity: the targets are met exactly}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_region_map}
///     \cgalParamDescription{the region that may move: where it is 1, the surface follows the
///                           targets, where it is 0, it stays, to the bit; between them is the
///                           collar, where the deformation fades out. Targets have to be where it
///                           is 1, in one part of the region; other parts stay}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptor as key and a
///                    number from 0 to 1 as value}
///     \cgalParamDefault{none: all vertices may move}
///   \cgalParamNEnd
///   \cgalParamNBegin{scale_bound}
///     \cgalParamDescription{lengths change by no more than this factor, on 98 % of the area,
///                           apart from the similarity}
///     \cgalParamType{a number > 1, or `std::nullopt` for no bound}
///     \cgalParamDefault{2; with `vertex_scale_map` 1.25}
///   \cgalParamNEnd
///   \cgalParamNBegin{limits}
///     \cgalParamDescription{what counts as success, see `Spin_report::fault()`}
///     \cgalParamType{`Spin_report::Limits`}
///     \cgalParamDefault{`Spin_report::Limits()` with `realised_share` 1}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \returns the report, which converts to `true` if the surface is what was requested. Otherwise
/// nothing has been written, and `Spin_report::fault()` tells why. `position_error` contains the
/// distances from the targets.
/// \throw Precondition_error if the mesh is not a connected, oriented manifold triangle mesh with
/// finite coordinates and, without `mollification`, positive areas; if there are no targets, one is
/// not finite or for no vertex of the mesh, two are for one vertex, or all are at one place; if a
/// parameter is out of its range. The message names the offending element
/// \throw Solver_error if a factorization fails
template <class TriangleMesh, class TargetRange,
          class NamedParameters = parameters::Default_named_parameters>
Spin_report conformal_deformation(TriangleMesh& mesh, const TargetRange& targets,
                                  const NamedParameters& np = parameters::default_values())
{
  const char* const function = "conformal_deformation";
  const Graph_view<TriangleMesh> graph(mesh, np, function);
  Spin_visitor silent;
  auto&& visitor = internal::parameter_or(np, CGAL::internal_np::visitor, silent);
  const auto options = internal::conformal_deformation_options(graph, np);
  const auto points = internal::read_control_points(
      graph, targets, internal::geometry_traits<TriangleMesh>(np), function);
  internal::Conformal_deformation deformation(graph.view(), options, function);
  Spin_result result = deformation.deform(points, internal::asking(visitor));
  internal::read_parameter(np, internal_np::limits, result.report.limits);
  if (result.report) internal::write_spin_result(mesh, graph, result, np);
  return result.report;
}

}  // namespace Conformal_geometry_processing
