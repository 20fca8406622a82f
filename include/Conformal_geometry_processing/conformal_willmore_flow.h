// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/Graph_view.h>
#include <Conformal_geometry_processing/core/boundary_parameters.h>
#include <Conformal_geometry_processing/core/geometry_traits.h>
#include <Conformal_geometry_processing/core/named_parameters.h>
#include <Conformal_geometry_processing/core/spin_parameters.h>
#include <Conformal_geometry_processing/core/write_points.h>
#include <Conformal_geometry_processing/flow/Conformal_willmore_flow.h>
#include <Conformal_geometry_processing/flow/Flow_report.h>
#include <Conformal_geometry_processing/mesh/requirements.h>

#include <string>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {

namespace internal {

template <class NamedParameters>
Flow_options flow_options(const NamedParameters& np)
{
  Flow_options o;
  read_parameter(np, internal_np::time_step, o.time_step);
  read_parameter(np, CGAL::internal_np::number_of_iterations, o.max_steps);
  read_parameter(np, internal_np::tolerance, o.energy_tolerance);
  read_parameter(np, internal_np::scale_bound, o.surface.scales.bound);
  read_exactness_and_mollification(np, o.surface);
  const Filter_options filter =
      parameter_or(np, internal_np::filter, Filter_options{o.filter_weight, o.filter_order});
  o.filter_weight = filter.weight;
  o.filter_order = filter.order;
  read_parameter(np, internal_np::balance, o.balance);
  read_parameter(np, internal_np::exact_conformal_class, o.surface.exact_conformal_class);
  read_parameter(np, internal_np::reduced_volume, o.reduced_volume);
  read_parameter(np, internal_np::dirac, o.surface.dirac);
  read_parameter(np, CGAL::internal_np::random_seed, o.surface.dirac.random_seed);
  return o;
}

/// reads the target areas from their map, if there is one
template <class TriangleMesh, class NamedParameters>
void read_target_areas(const Graph_view<TriangleMesh>& graph, const NamedParameters& np,
                       Flow_options& options)
{
  if constexpr (has_parameter<NamedParameters, internal_np::vertex_target_area_map_t>) {
    options.balance = Flow_options::Balance::prescribed;
    options.target_areas = read_vertex_numbers(
        graph, CGAL::parameters::get_parameter(np, internal_np::vertex_target_area_map));
  }
}

/// the final surface of a flow, 3 x |V|, and the report
struct Flow_result {
  Points positions;
  Flow_report report;
};

/// Computes `conformal_willmore_flow()` for a mesh or one of its components, without writing to it.
template <class TriangleMesh, class NamedParameters>
Flow_result flow_result(const Graph_view<TriangleMesh>& graph, const NamedParameters& np,
                        const std::string& function)
{
  static_assert(
      only_known_parameters<
          NamedParameters, CGAL::internal_np::vertex_point_t, CGAL::internal_np::geom_traits_t,
          CGAL::internal_np::number_of_iterations_t, CGAL::internal_np::random_seed_t,
          CGAL::internal_np::visitor_t, internal_np::output_vertex_point_map_t,
          internal_np::sparse_solver_t, internal_np::dirac_t, internal_np::time_step_t,
          internal_np::tolerance_t, internal_np::filter_t, internal_np::balance_t,
          internal_np::vertex_target_area_map_t, internal_np::exactness_t,
          internal_np::exact_conformal_class_t, internal_np::reduced_volume_t,
          internal_np::scale_bound_t, internal_np::mollification_t,
          internal_np::curvature_direction_t, internal_np::boundary_direction_t,
          internal_np::boundary_direction_map_t>,
      "conformal_willmore_flow(): unknown named parameter, see the manual for those it accepts");
  Flow_options options = flow_options(np);
  read_target_areas(graph, np, options);
  options.surface.boundary = boundary_condition(graph, np, function);
  Flow_visitor silent;
  auto&& visitor = parameter_or(np, CGAL::internal_np::visitor, silent);
  Conformal_willmore_flow flow(
      graph.view(), options,
      parameter_or(np, internal_np::curvature_direction, Willmore_direction()), function);
  Flow_report report = flow.run(visitor);
  return {flow.positions(), std::move(report)};
}

}  // namespace internal

/// \ingroup PkgEntryPoints
/// \brief makes a surface as smooth as its conformal class allows, in a few large steps that
/// preserve angles, and thus textures and the shapes of triangles [CGP 6.4].
///
/// Each step smooths the surface within its conformal class, and then applies a spin transformation
/// by rho = -tau H; spheres become round, tori become tori of Clifford type. Surfaces of any genus
/// stay closed. Area and centroid are preserved. The energy, the integral of H^2, decreases in
/// every step: a step that would increase it is repeated with half of tau. With binormals kept,
/// H becomes constant, or the flow ends where only closing around holes keeps it from that; there
/// steps may increase the energy by what they miss of the binormals.
///
/// Surfaces stay on the discrete conformal class of their intrinsic Delaunay triangulation: its
/// length cross-ratios are kept to 1e-10 where double precision allows. So errors of the steps do
/// not add up, surfaces with handles keep their conformal type, and boundaries their first tangents
/// or binormals. `exact_conformal_class(false)` is the flow of the thesis, without this and without
/// smoothing; `Flow_options::fairing` switches off smoothing alone.
///
/// Long thin limbs would have to shrink to nothing: where that is beyond the limits of a conformal
/// map, or no step is possible, the flow stops with the last surface within them, and reports the
/// reason.
///
/// Computes in double precision for every kernel. Each step factors a sparse quaternionic matrix on
/// the vertices (two if there are handles); orderings and symbolic factorizations are computed
/// once. Use `Conformal_willmore_flow` for single steps.
///
/// \tparam TriangleMesh see \ref triangle_mesh_requirements
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh the surface, oriented; its points are overwritten
/// \param np optional named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{time_step}
///     \cgalParamDescription{the largest tau in rho = -tau H: stable below 2 on every mesh; 1
///                           removes high frequencies in one step}
///     \cgalParamType{`double`}
///     \cgalParamDefault{1}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_iterations}
///     \cgalParamDescription{maximum number of steps}
///     \cgalParamType{`unsigned int`}
///     \cgalParamDefault{100}
///   \cgalParamNEnd
///   \cgalParamNBegin{tolerance}
///     \cgalParamDescription{the flow stops if the energy changes by less than this share of it, in
///                           a time of 1}
///     \cgalParamType{`double`}
///     \cgalParamDefault{1e-4}
///   \cgalParamNEnd
///   \cgalParamNBegin{filter}
///     \cgalParamDescription{smoothes details and preserves the overall shape, see
///                           `Curvature_filter`; its amount has no effect}
///     \cgalParamType{`Filter_options`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{balance}
///     \cgalParamDescription{the vertex areas towards which the surface is balanced among its
///                           Moebius transforms, which do not differ in curvature}
///     \cgalParamType{`Flow_options::Balance`}
///     \cgalParamDefault{`Flow_options::Balance::none`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_target_area_map}
///     \cgalParamDescription{target areas of the balance; only their ratios matter}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptor as key; its value
///                    converts by `CGAL::to_double()`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{boundary_direction}
///     \cgalParamDescription{the direction of the boundary frame that is kept or prescribed}
///     \cgalParamType{`Boundary_direction`, not the normal}
///     \cgalParamDefault{the tangent, if there is a `boundary_direction_map`; otherwise none, and
///                       the boundary is free}
///   \cgalParamNEnd
///   \cgalParamNBegin{boundary_direction_map}
///     \cgalParamDescription{the new direction at each vertex on the boundary}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptor as key and a
///                    nonzero vector as value}
///     \cgalParamDefault{the initial direction; with `exact_conformal_class(false)`, that before
///                       each step}
///   \cgalParamNEnd
///   \cgalParamNBegin{exact_conformal_class}
///     \cgalParamDescription{whether surfaces stay on their exact discrete conformal class}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`true`}
///   \cgalParamNEnd
///   \cgalParamNBegin{reduced_volume}
///     \cgalParamDescription{the volume, by that of the round sphere of the same area, that a
///                           closed surface keeps, or reaches by a twentieth in a step: see
///                           `Enclosure`. The shapes of least energy are those of vesicles}
///     \cgalParamType{`double`, above 0 and up to 1, or `std::nullopt`}
///     \cgalParamDefault{none: the volume is free}
///   \cgalParamNEnd
///   \cgalParamNBegin{scale_bound}
///     \cgalParamDescription{the largest factor by which lengths may differ from those of the
///                           input, on 98 % of the area: limbs, and what is behind a thin neck,
///                           become no smaller}
///     \cgalParamType{`double`, above 1, or `std::nullopt` for no bound}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{exactness}
///     \cgalParamDescription{how surfaces are kept closed around handles and holes}
///     \cgalParamType{`Exactness`}
///     \cgalParamDefault{`Exactness::adjoint`}
///   \cgalParamNEnd
///   \cgalParamNBegin{mollification}
///     \cgalParamDescription{admits faces of any thinness, also of area zero, see
///                           `spin_transform()`. On the exact class, vertices of faces that flips
///                           of edges leave without area move first, by about a thousandth of
///                           their edges}
///     \cgalParamType{`double`, between 0 and 1; 1e-6 is a good value}
///     \cgalParamDefault{none: faces of area zero are rejected}
///   \cgalParamNEnd
///   \cgalParamNBegin{curvature_direction}
///     \cgalParamDescription{the direction of another curvature flow}
///     \cgalParamType{a model of `CurvatureDirection`}
///     \cgalParamDefault{`Willmore_direction`}
///   \cgalParamNEnd
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{is called after every step and may stop the flow}
///     \cgalParamType{a `std::reference_wrapper` of a model of `FlowVisitor`}
///     \cgalParamDefault{`Flow_visitor`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_point_map, output_vertex_point_map, geom_traits, sparse_solver}
///     \cgalParamDescription{see `spin_transform()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{dirac}
///     \cgalParamDescription{how spins are found, such as the eigensolver}
///     \cgalParamType{`Dirac_options`}
///     \cgalParamDefault{that of `Flow_options`}
///   \cgalParamNEnd
///   \cgalParamNBegin{random_seed}
///     \cgalParamDescription{seed of the second start vector of the eigenvalue solver}
///     \cgalParamType{`unsigned int`}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \returns the report, which contains the reason to stop, and converts to `true` if the flow has
/// converged or made the requested number of steps, and is conformal from start to end. In every
/// case the points are those of the last complete step, which is within `Flow_options::limits`.
/// \throw Precondition_error if the mesh is not a connected, oriented manifold triangle mesh with
/// finite coordinates and positive areas, or a parameter is out of its range; the message names the
/// offending element
/// \throw Solver_error if the analysis fails. After any exception, also of the visitor, the mesh is
/// unchanged.
template <class TriangleMesh, class NamedParameters = parameters::Default_named_parameters>
Flow_report conformal_willmore_flow(TriangleMesh& mesh,
                                    const NamedParameters& np = parameters::default_values())
{
  const std::string function = "conformal_willmore_flow";
  const Graph_view<TriangleMesh> graph(mesh, np, function);
  internal::Flow_result result = internal::flow_result(graph, np, function);
  internal::write_points(mesh, graph, result.positions, np);
  return std::move(result.report);
}

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
