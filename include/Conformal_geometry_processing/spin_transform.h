// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/Graph_view.h>
#include <Conformal_geometry_processing/core/boundary_parameters.h>
#include <Conformal_geometry_processing/core/named_parameters.h>
#include <Conformal_geometry_processing/core/spin_parameters.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <string>
#include <vector>

namespace Conformal_geometry_processing {

namespace internal {

/// The options that the named parameters of `spin_transform()` specify.
template <class TriangleMesh, class NamedParameters>
Spin_transformation_options spin_transformation_options(const Graph_view<TriangleMesh>& graph,
                                                        const NamedParameters& np,
                                                        const std::string& function)
{
  static_assert(
      only_known_parameters<
          NamedParameters, CGAL::internal_np::vertex_point_t, CGAL::internal_np::geom_traits_t,
          CGAL::internal_np::number_of_iterations_t, CGAL::internal_np::random_seed_t,
          CGAL::internal_np::visitor_t, internal_np::output_vertex_point_map_t,
          internal_np::vertex_spin_map_t, internal_np::sparse_solver_t, internal_np::dirac_t,
          internal_np::exactness_t, internal_np::limits_t, internal_np::tolerance_t,
          internal_np::boundary_direction_t, internal_np::boundary_direction_map_t,
          internal_np::vertex_target_point_map_t, internal_np::position_weight_t,
          internal_np::mollification_t, internal_np::scale_bound_t, internal_np::vertex_scale_map_t,
          internal_np::vertex_scale_weight_map_t, internal_np::exact_conformal_class_t,
          CGAL::internal_np::vertex_is_constrained_t, CGAL::internal_np::vertex_normal_map_t>,
      "spin_transform(): unknown named parameter, see the manual for those it accepts");
  Spin_transformation_options options;
  options.boundary = boundary_condition(graph, np, function);
  read_request(np, options);
  read_scale_control(graph, np, options);
  read_parameter(np, internal_np::exact_conformal_class, options.exact_conformal_class);
  return options;
}

}  // namespace internal

/// \ingroup PkgEntryPoints
/// \brief deforms a surface conformally so that its mean curvature changes as prescribed
/// [CGP (5.3)-(5.5)].
///
/// Finds spins lambda with (D - rho) lambda = gamma lambda and integrates the new edges
/// conjugate(lambda) df lambda. The new surface satisfies H~ |lambda|^2 = H + rho + gamma: positive
/// rho bulges along the normals, and its constant part has no effect. Angles are preserved up to
/// the discretisation error; area and centroid are preserved.
///
/// On long limbs, rho alone may scale lengths by large factors. By default the nearest rho is
/// applied whose factors are within [1/2, 2]. With `scale_bound(std::nullopt)` there is no bound,
/// and lambda is the eigenvector of the thesis.
///
/// On a surface of genus > 0, not every rho belongs to a surface that closes up around its handles:
/// the inadmissible part is left out, and a strong rho is applied in several steps. The report
/// contains what was left out (`missing_share`), the number of `steps`, and the completed share of
/// the path (`reached`).
///
/// At a boundary, the new directions of the tangents, of the binormals, or of anything between
/// these and the normals can be prescribed, or the positions of the vertices. A free boundary moves
/// as little as possible. Data that no surface has are rejected: the report is `false` and names
/// the `boundary_fault`.
///
/// Computes in double precision for every kernel. Sparse factorizations of quaternionic matrices on
/// the vertices dominate time and memory: with a bound one to five, and 30 to 150 solves; without
/// one, on smooth spheres, about six, see `Spin_transformation`. Use `Spin_transformation`
/// for several rho on one mesh.
///
/// \tparam TriangleMesh see \ref triangle_mesh_requirements
/// \tparam CurvaturePotentialMap a model of `ReadablePropertyMap` whose key is the vertex or the
/// face descriptor of the mesh, and whose value converts by `CGAL::to_double()`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh the surface, oriented with normals outward; its points are overwritten
/// \param rho the change of mean curvature, in 1/length of the mesh
/// \param np optional named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the points of the vertices; read, and written unless
///                           `output_vertex_point_map` is given}
///     \cgalParamType{a model of `ReadWritePropertyMap` with the vertex descriptor as key}
///     \cgalParamDefault{`get(CGAL::vertex_point, mesh)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{output_vertex_point_map}
///     \cgalParamDescription{receives the new points}
///     \cgalParamType{a model of `WritablePropertyMap` with the vertex descriptor as key}
///     \cgalParamDefault{the vertex point map}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_spin_map}
///     \cgalParamDescription{receives lambda}
///     \cgalParamType{a model of `WritablePropertyMap`; its value is any type that
///                    `Quaternion_access` knows}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{geom_traits}
///     \cgalParamType{a model of `ConformalGeometryTraits_3`}
///     \cgalParamDefault{the kernel of the points}
///   \cgalParamNEnd
///   \cgalParamNBegin{sparse_solver}
///     \cgalParamDescription{the linear solver; only its type matters, not its value}
///     \cgalParamType{a model of `SparseHermitianSolverTraits`}
///     \cgalParamDefault{`Default_solver_traits`}
///   \cgalParamNEnd
///   \cgalParamNBegin{exactness}
///     \cgalParamDescription{how handles are kept closed; `std::nullopt`: not at all, in one step}
///     \cgalParamType{`Exactness`, or `std::nullopt`}
///     \cgalParamDefault{`Exactness::adjoint`}
///   \cgalParamNEnd
///   \cgalParamNBegin{scale_bound}
///     \cgalParamDescription{b > 1: lengths are multiplied by factors in [1/b, b] on 98 % of the
///                           area, and by up to 1.5 times that at tips, at unchanged total area;
///                           where rho would do more, the nearest rho that does not is applied.
///                           `Spin_report::scales` tells what was kept. A factor of 1.5 to 3 keeps
///                           limbs recognisable. Less of rho is applied, too, where the map would
///                           be beyond `limits`. Cannot be combined with `vertex_target_point_map`}
///     \cgalParamType{`double`, or `std::nullopt` for no bound: rho is applied as it is}
///     \cgalParamDefault{2; with `vertex_scale_map` 1.25; none with `boundary_direction_map` or
///                       `vertex_target_point_map`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_scale_map}
///     \cgalParamDescription{wanted factors of lengths, to which the bound is relative; only their
///                           ratios matter. Needs a bound}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptor as key and a
///                    positive number as value}
///     \cgalParamDefault{1}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_scale_weight_map}
///     \cgalParamDescription{how much the size of the surface matters there; where it is 0,
///                           lengths may change freely. Needs a bound}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptor as key and a
///                    number >= 0 as value}
///     \cgalParamDefault{1}
///   \cgalParamNEnd
///   \cgalParamNBegin{exact_conformal_class}
///     \cgalParamDescription{whether the result is moved, by as little as possible, to the surface
///                           with exactly the length cross-ratios of the mesh, up to rounding:
///                           `Spin_report::exact_class`. Takes one or two factorizations more; with
///                           `scale_bound` and `mollification`, too, not with target points}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{limits}
///     \cgalParamDescription{what counts as success, see `Spin_report::fault()`}
///     \cgalParamType{`Spin_report::Limits`}
///     \cgalParamDefault{`Spin_report::Limits()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{boundary_direction}
///     \cgalParamDescription{the direction of the boundary frame that is prescribed}
///     \cgalParamType{`Boundary_direction`, not the normal}
///     \cgalParamDefault{the tangent, if there is a `boundary_direction_map`; otherwise none, and
///                       the boundary is free}
///   \cgalParamNEnd
///   \cgalParamNBegin{boundary_direction_map}
///     \cgalParamDescription{the new direction at each vertex on the boundary}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptor as key and a
///                    nonzero vector as value}
///     \cgalParamDefault{the present direction}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_target_point_map}
///     \cgalParamDescription{the new positions of the vertices on the boundary, and on the closed
///                           curves inside that are constrained; cannot be combined with
///                           directions}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptor as key; without
///                    `vertex_normal_map` it must have points for all vertices}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{position_weight}
///     \cgalParamDescription{weight of the positions against conformality: with a finite one the
///                           boundary is attached to them, in a layer of width radius / weight}
///     \cgalParamType{a positive number}
///     \cgalParamDefault{infinity: the positions are exact}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_normal_map}
///     \cgalParamDescription{normals of the new surface at prescribed boundary points}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptor as key and a
///                    vector as value}
///     \cgalParamDefault{the normals of the surface with the target points of all vertices}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_is_constrained_map}
///     \cgalParamDescription{which vertices have target points: the whole boundary, and vertices
///                           inside that form closed curves of edges}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptor as key and `bool`
///                    as value}
///     \cgalParamDefault{true on the boundary}
///   \cgalParamNEnd
///   \cgalParamNBegin{mollification}
///     \cgalParamDescription{admits faces of any thinness, also of area zero: solves the equation
///                           on the intrinsic Delaunay triangulation, and adds to all edges the
///                           length that thin faces lack to form triangles, at most this share of
///                           the mean length. Certificate and
///                           preserved area refer to the `well_shaped_faces()`}
///     \cgalParamType{`double`, between 0 and 1; 1e-6 is a good value}
///     \cgalParamDefault{none: faces of area zero are rejected}
///   \cgalParamNEnd
///   \cgalParamNBegin{dirac}
///     \cgalParamDescription{without a bound on lengths: how the eigenvector is found: the discrete
///                           problem, of which the generalized one requires rho on faces; the
///                           branch and the kernel with directions; the eigensolver; the number of
///                           stages of a strong rho. The three parameters below take precedence}
///     \cgalParamType{`Dirac_options`}
///     \cgalParamDefault{`Dirac_options()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{tolerance}
///     \cgalParamDescription{upper bound of the error estimate of lambda as an eigenvector, that
///                           is without a bound on lengths}
///     \cgalParamType{`double`}
///     \cgalParamDefault{1e-8}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_iterations}
///     \cgalParamDescription{without a bound on lengths: maximum number of iterations of the
///                           eigenvalue solver in all}
///     \cgalParamType{`unsigned int`}
///     \cgalParamDefault{200}
///   \cgalParamNEnd
///   \cgalParamNBegin{random_seed}
///     \cgalParamDescription{without a bound on lengths: seed of the second start vector of the
///                           eigenvalue solver}
///     \cgalParamType{`unsigned int`}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{is called after every iteration and may cancel}
///     \cgalParamType{a `std::reference_wrapper` of a model of `SpinVisitor`}
///     \cgalParamDefault{`Spin_visitor`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \returns the report, which converts to `true` if the surface is what was requested. Otherwise
/// nothing has been written, and `Spin_report::fault()` tells why.
/// \throw Precondition_error if the mesh is not a connected, oriented manifold triangle mesh with
/// finite coordinates and, without `mollification`, positive areas; if rho is not finite; if the
/// boundary data do not fit the boundary; or if `mollification` is not between 0 and 1. The message
/// names the offending element
/// \throw Solver_error if a factorization fails
template <class TriangleMesh, class CurvaturePotentialMap,
          class NamedParameters = parameters::Default_named_parameters>
Spin_report spin_transform(TriangleMesh& mesh, CurvaturePotentialMap rho,
                           const NamedParameters& np = parameters::default_values())
{
  const char* const function = "spin_transform";
  const Graph_view<TriangleMesh> graph(mesh, np, function);
  const Curvature_potential potential = internal::read_curvature_potential(graph, rho);
  Spin_visitor silent;
  auto&& visitor = internal::parameter_or(np, CGAL::internal_np::visitor, silent);
  const Spin_result result =
      Spin_transformation(graph.view(), internal::spin_transformation_options(graph, np, function),
                          function)
          .transform(potential, internal::asking(visitor));
  if (result.report) internal::write_spin_result(mesh, graph, result, np);
  return result.report;
}

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
