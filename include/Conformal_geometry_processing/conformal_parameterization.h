// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/Graph_view.h>
#include <Conformal_geometry_processing/core/named_parameters.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/parameterization/place_in_plane.h>
#include <Conformal_geometry_processing/parameterization/spectral_parameterization.h>
#include <Quaternionic_linear_algebra/direct/Solver_ref.h>

#include <boost/property_map/property_map.hpp>

#include <complex>
#include <string>
#include <type_traits>
#include <vector>

namespace Conformal_geometry_processing {

namespace internal {

/// Constructs a point of the plane of any type from two numbers, in parentheses or in braces
template <class Point>
Point plane_point(const std::complex<double>& z)
{
  if constexpr (std::is_constructible_v<Point, double, double>)
    return Point(z.real(), z.imag());
  else
    return Point{z.real(), z.imag()};
}

template <class NamedParameters>
Parameterization_options parameterization_options(const NamedParameters& np)
{
  Parameterization_options options;
  read_parameter(np, internal_np::tolerance, options.tolerance);
  read_parameter(np, CGAL::internal_np::number_of_iterations, options.maximum_number_of_iterations);
  read_parameter(np, internal_np::sparse_solver, options.solvers);
  return options;
}

/// Computes the parameterization of a mesh or of one of its components, without writing anything.
template <class TriangleMesh, class NamedParameters>
Parameterization_result parameterization_result(const Graph_view<TriangleMesh>& graph,
                                                const NamedParameters& np,
                                                const std::string& function)
{
  static_assert(
      only_known_parameters<NamedParameters, CGAL::internal_np::vertex_point_t,
                            CGAL::internal_np::geom_traits_t,
                            CGAL::internal_np::number_of_iterations_t, internal_np::tolerance_t,
                            internal_np::sparse_solver_t>,
      "conformal_parameterization(): unknown named parameter, see the manual for those it accepts");
  return spectral_parameterization(graph.view(), parameterization_options(np), function);
}

/// Writes one point of the plane for each vertex.
template <class TriangleMesh, class VertexUVMap>
void write_plane_points(const Graph_view<TriangleMesh>& graph, const Eigen::VectorXcd& z,
                        VertexUVMap uv_map)
{
  using UV = typename boost::property_traits<VertexUVMap>::value_type;
  for (int v = 0; v < graph.view().size_of_vertices(); ++v)
    put(uv_map, graph.vertex(v), plane_point<UV>(z[v]));
}

}  // namespace internal

/// \ingroup PkgEntryPoints
/// \brief Flattens a surface with boundary with small angle distortion: computes the map to the
/// plane that minimizes the conformal energy [CGP 6.1].
///
/// By default this is the spectral conformal parameterization of Mullen et al. No vertices are
/// pinned: among all maps with the same variance of the boundary (mean squared distance from its
/// centre) it minimizes the energy |D psi|^2, psi = u - v N, by an eigenvector. The surface need
/// not be a disk; it may have holes. Faces rarely flip, and distant parts rarely overlap, but this
/// is not guaranteed; the report counts flipped faces and measures overlaps.
///
/// The image has the area of the surface (sum of the areas of the faces), and its longest loop is
/// centred at the origin. Computes in double precision for any kernel. One factorization of a
/// complex |V| x |V| matrix and a few solves.
///
/// \tparam TriangleMesh see \ref triangle_mesh_requirements
/// \tparam VertexUVMap a model of `WritablePropertyMap` with the vertex descriptor as key and a
/// point of the plane as value: of a kernel of \cgal, `Eigen::Vector2d`, `std::array<double, 2>`,
/// `std::complex<double>`, or any type that is constructed from two numbers
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
/// \param mesh the surface
/// \param uv_map receives the point of each vertex
/// \param np optional named parameters
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the points of the vertices}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptor as key}
///     \cgalParamDefault{`get(CGAL::vertex_point, mesh)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{geom_traits}
///     \cgalParamType{a model of `ConformalGeometryTraits_3`}
///     \cgalParamDefault{the kernel of the points}
///   \cgalParamNEnd
///   \cgalParamNBegin{tolerance}
///     \cgalParamDescription{relative error of the map in the norm of the energy}
///     \cgalParamType{`double`}
///     \cgalParamDefault{1e-6}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_iterations}
///     \cgalParamDescription{maximal number of iterations}
///     \cgalParamType{`unsigned int`}
///     \cgalParamDefault{100; three to ten are usual}
///   \cgalParamNEnd
///   \cgalParamNBegin{sparse_solver}
///     \cgalParamDescription{the linear solver; only its type matters, not its value}
///     \cgalParamType{a model of `SparseHermitianSolverTraits`, also for `std::complex<double>`;
///                    direct, in double precision}
///     \cgalParamDefault{`Default_solver_traits`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \returns the report, which converts to `true` if the map was found. Otherwise nothing is
/// written.
/// \throw Precondition_error if the mesh is not a connected, oriented manifold triangle mesh with
/// boundary, finite coordinates and positive areas; the message names the element
/// \throw Solver_error if the energy cannot be factorized
/// \sa `minimal_surface()`, which yields the flat image with given planar boundary directions
template <class TriangleMesh, class VertexUVMap,
          class NamedParameters = parameters::Default_named_parameters>
Parameterization_report conformal_parameterization(
    const TriangleMesh& mesh, VertexUVMap uv_map,
    const NamedParameters& np = parameters::default_values())
{
  const std::string function = "conformal_parameterization";
  const Graph_view<TriangleMesh> graph(mesh, np, function);
  const internal::Parameterization_result result =
      internal::parameterization_result(graph, np, function);
  if (result.report) internal::write_plane_points(graph, result.z, uv_map);
  return result.report;
}

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
