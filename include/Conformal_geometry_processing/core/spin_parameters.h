// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/Graph_view.h>
#include <Conformal_geometry_processing/core/named_parameters.h>
#include <Conformal_geometry_processing/core/write_points.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Conformal_geometry_processing/spin/Control_point.h>
#include <Conformal_geometry_processing/spin/Dirac_solution.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Quaternionic_linear_algebra/direct/Solver_ref.h>
#include <Quaternionic_linear_algebra/exceptions.h>
#include <Quaternionic_linear_algebra/krylov/Eigensolver_result.h>

#include <CGAL/number_utils.h>
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \brief Reads how the eigenvector is found: by `dirac`, where the parameters that other functions
/// have, too, take precedence.
template <class NamedParameters>
void read_dirac_options(const NamedParameters& np, Dirac_options& o)
{
  read_parameter(np, internal_np::dirac, o);
  read_parameter(np, internal_np::tolerance, o.tolerance);
  read_parameter(np, CGAL::internal_np::number_of_iterations, o.max_iterations);
  read_parameter(np, CGAL::internal_np::random_seed, o.random_seed);
}

/// the solvers that named parameters tell of
template <class NamedParameters>
Spin_solvers spin_solvers(const NamedParameters& np)
{
  return parameter_or(np, internal_np::sparse_solver, Spin_solvers());
}

/// passes the progress of an eigensolver to the visitor of the named parameters, and asks whether
/// to go further; the visitor must outlive it
template <class Visitor>
auto asking(Visitor& visitor)
{
  return [&visitor](const Eigensolver_progress& progress) {
    visitor.on_iteration(progress);
    return visitor.go_further();
  };
}

/// the numbers of a map with one per vertex, in the order of the view
template <class TriangleMesh, class VertexNumberMap>
Eigen::VectorXd read_vertex_numbers(const Graph_view<TriangleMesh>& graph, VertexNumberMap map)
{
  Eigen::VectorXd numbers(graph.view().size_of_vertices());
  for (int v = 0; v < numbers.size(); ++v) numbers[v] = CGAL::to_double(get(map, graph.vertex(v)));
  return numbers;
}

/// \brief reads `vertex_scale_map`, `vertex_scale_weight_map` and `scale_bound`.
/// \pre the boundary condition has been read: the default of the bound depends on it
template <class TriangleMesh, class NamedParameters>
void read_scale_control(const Graph_view<TriangleMesh>& graph, const NamedParameters& np,
                        Spin_transformation_options& options)
{
  using CGAL::parameters::get_parameter;
  Scale_control& control = options.scales;
  if constexpr (has_parameter<NamedParameters, internal_np::vertex_scale_map_t>)
    control.factors = read_vertex_numbers(graph, get_parameter(np, internal_np::vertex_scale_map));
  if constexpr (has_parameter<NamedParameters, internal_np::vertex_scale_weight_map_t>)
    control.weights =
        read_vertex_numbers(graph, get_parameter(np, internal_np::vertex_scale_weight_map));
  control.bound = default_bound(options);
  read_parameter(np, internal_np::scale_bound, control.bound);
}

/// reads how handles stay closed, the mollification and the solvers
template <class NamedParameters>
void read_exactness_and_mollification(const NamedParameters& np,
                                      Spin_transformation_options& options)
{
  read_parameter(np, internal_np::exactness, options.exactness);
  read_parameter(np, internal_np::mollification, options.mollification);
  read_parameter(np, internal_np::sparse_solver, options.solvers);
}

/// reads what named parameters request of a spin transformation, but for the boundary and scales
template <class NamedParameters>
void read_request(const NamedParameters& np, Spin_transformation_options& options)
{
  read_exactness_and_mollification(np, options);
  read_dirac_options(np, options.dirac);
  read_parameter(np, internal_np::limits, options.limits);
}

/// rho from a map of the vertices or of the faces
template <class TriangleMesh, class CurvaturePotentialMap>
Curvature_potential read_curvature_potential(const Graph_view<TriangleMesh>& graph,
                                             CurvaturePotentialMap rho)
{
  using Key = typename boost::property_traits<CurvaturePotentialMap>::key_type;
  constexpr bool on_vertices =
      std::is_same_v<Key, typename Graph_view<TriangleMesh>::vertex_descriptor>;
  constexpr bool on_faces = std::is_same_v<Key, typename Graph_view<TriangleMesh>::face_descriptor>;
  static_assert(on_vertices || on_faces,
                "the key type of rho must be the vertex or the face descriptor of the mesh");
  if constexpr (on_vertices) {
    return Curvature_potential::on_vertices(read_vertex_numbers(graph, rho));
  } else {
    Eigen::VectorXd values(graph.view().size_of_faces());
    for (int f = 0; f < values.size(); ++f) values[f] = CGAL::to_double(get(rho, graph.face(f)));
    return Curvature_potential::on_faces(std::move(values));
  }
}

/// \brief the index of a vertex in the view. Only compares descriptors, because what is not a
/// vertex of the mesh has no entry in a property map.
/// \param k the target that is for it, named in the
/// exception
template <class TriangleMesh, class Vertex>
int index_of(const Graph_view<TriangleMesh>& graph, const Vertex& vertex, std::size_t k,
             const std::string& function)
{
  for (int v = 0; v < graph.view().size_of_vertices(); ++v)
    if (graph.vertex(v) == vertex) return v;
  throw Precondition_error(function,
                           "target " + std::to_string(k) + " is for no vertex of the mesh");
}

/// the coefficients of a `CGAL::Aff_transformation_3`
template <class Transformation>
Eigen::Affine3d read_motion(const Transformation& transformation)
{
  Eigen::Affine3d motion = Eigen::Affine3d::Identity();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 4; ++j) motion(i, j) = CGAL::to_double(transformation.cartesian(i, j));
  return motion;
}

/// \brief the control points of a range of pairs: of a vertex and its new point, or of a range of
/// vertices and their motion.
template <class TriangleMesh, class TargetRange, class GeomTraits>
std::vector<Control_point> read_control_points(const Graph_view<TriangleMesh>& graph,
                                               const TargetRange& targets, const GeomTraits& traits,
                                               const std::string& function)
{
  using Vertex = typename Graph_view<TriangleMesh>::vertex_descriptor;
  std::vector<Control_point> points;
  std::size_t k = 0;
  for (const auto& [where, to] : targets) {
    if constexpr (std::is_convertible_v<decltype(where), Vertex>) {
      points.push_back(control_point(index_of<TriangleMesh, Vertex>(graph, where, k, function),
                                     coordinates_of(to, traits)));
    } else {
      std::vector<int> region;
      for (const Vertex& v : where) region.push_back(index_of(graph, v, k, function));
      if (region.empty())
        throw Precondition_error(function, "target " + std::to_string(k) + " has no vertices");
      for (Control_point& p : region_control_points(graph.view(), region, read_motion(to)))
        points.push_back(std::move(p));
    }
    ++k;
  }
  return points;
}

/// Writes lambda, then the points. A map that throws leaves the points as they were
/// (`write_points()`).
template <class TriangleMesh, class NamedParameters>
void write_spin_result(TriangleMesh& mesh, const Graph_view<TriangleMesh>& graph,
                       const Spin_result& result, const NamedParameters& np)
{
  write_spins(graph, result.lambda, np);
  write_points(mesh, graph, result.positions, np);
}

}  // namespace Conformal_geometry_processing::internal
