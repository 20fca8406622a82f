// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/Graph_view.h>
#include <Conformal_geometry_processing/core/geometry_traits.h>
#include <Conformal_geometry_processing/core/named_parameters.h>
#include <Conformal_geometry_processing/mesh/Boundary_frames.h>
#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/spin/Boundary_condition.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief A direction in the frame (T, N, B) of a boundary vertex: the value of the named parameter
/// `boundary_direction`.
struct Boundary_direction {
  double tangent = 0, normal = 0, binormal = 0;
};

namespace internal {

/// Reads the vectors of a map at some vertices; 3 x count.
template <class TriangleMesh, class Map>
Points read_vectors(const Graph_view<TriangleMesh>& graph, const std::vector<int>& vertices,
                    Map map)
{
  Points p(3, static_cast<Eigen::Index>(vertices.size()));
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const auto& v = get(map, graph.vertex(vertices[k]));
    p.col(static_cast<Eigen::Index>(k)) << CGAL::to_double(v.x()), CGAL::to_double(v.y()),
        CGAL::to_double(v.z());
  }
  return p;
}

/// Reads the points of a map at some vertices, with coordinates from the traits; 3 x count.
template <class TriangleMesh, class Map, class GeomTraits>
Points read_points(const Graph_view<TriangleMesh>& graph, const std::vector<int>& vertices, Map map,
                   const GeomTraits& traits)
{
  Points points(3, static_cast<Eigen::Index>(vertices.size()));
  for (std::size_t k = 0; k < vertices.size(); ++k)
    points.col(static_cast<Eigen::Index>(k)) =
        coordinates_of(get(map, graph.vertex(vertices[k])), traits);
  return points;
}

/// Returns the boundary normals of the surface with other positions.
inline Points normals_at(const Mesh_view& mesh, const Points& positions,
                         const std::vector<int>& vertices)
{
  const Points all = vertex_normals(Mesh_view(positions, mesh.corners()), Normal_weight::angle);
  Points normals(3, static_cast<Eigen::Index>(vertices.size()));
  for (std::size_t k = 0; k < vertices.size(); ++k)
    normals.col(static_cast<Eigen::Index>(k)) = all.col(vertices[k]);
  return normals;
}

/// Returns the closed curves inside the surface in `vertex_is_constrained_map`, if there is one,
/// which must contain the boundary.
template <class TriangleMesh, class NamedParameters>
std::vector<std::vector<int>> constrained_curves(const Graph_view<TriangleMesh>& graph,
                                                 const std::vector<int>& vertices,
                                                 const NamedParameters& np,
                                                 const std::string& function)
{
  if constexpr (has_parameter<NamedParameters, CGAL::internal_np::vertex_is_constrained_t>) {
    auto is_constrained =
        CGAL::parameters::get_parameter(np, CGAL::internal_np::vertex_is_constrained);
    refuse_if_any(
        static_cast<int>(vertices.size()),
        [&](int k) {
          return !get(is_constrained, graph.vertex(vertices[static_cast<std::size_t>(k)]));
        },
        [&](int k) { return name_of_vertex(vertices[static_cast<std::size_t>(k)]); }, function,
        "boundary #vertex not constrained",
        "the problem is well posed only if all of the boundary is");
    std::vector<char> is_inside(static_cast<std::size_t>(graph.view().size_of_vertices()));
    for (std::size_t v = 0; v < is_inside.size(); ++v)
      is_inside[v] = get(is_constrained, graph.vertex(static_cast<int>(v)));
    for (const int v : vertices) is_inside[static_cast<std::size_t>(v)] = 0;
    return closed_curves(graph.view(), is_inside, function);
  }
  return {};
}

/// Returns the boundary condition given by named parameters: `vertex_target_point_map` for
/// positions, with `position_weight`, `boundary_direction` and `boundary_direction_map` for
/// directions (the tangents, if only the second is given), otherwise a free boundary. \throw
/// Precondition_error if `vertex_is_constrained_map` contains only a part of the boundary, or
/// vertices inside that form no closed curves
template <class TriangleMesh, class NamedParameters>
Boundary_condition boundary_condition(const Graph_view<TriangleMesh>& graph,
                                      const NamedParameters& np, const std::string& function)
{
  using CGAL::parameters::get_parameter;
  constexpr bool has_targets =
      has_parameter<NamedParameters, internal_np::boundary_direction_map_t>;
  constexpr bool has_direction = has_parameter<NamedParameters, internal_np::boundary_direction_t>;
  constexpr bool has_points =
      has_parameter<NamedParameters, internal_np::vertex_target_point_map_t>;
  static_assert(!(has_points && (has_targets || has_direction)),
                "positions and directions of the boundary cannot be prescribed both");
  Boundary_condition condition;
  if constexpr (!has_points && !has_targets && !has_direction) return condition;
  const Mesh_view& mesh = graph.view();
  std::vector<int> vertices = boundary_frames(mesh).vertices;
  if constexpr (has_points) {
    condition.curves = constrained_curves(graph, vertices, np, function);
    vertices = frames_of(mesh, condition).vertices;
    const auto target = get_parameter(np, internal_np::vertex_target_point_map);
    const auto traits = geometry_traits<TriangleMesh>(np);
    condition.kind = Boundary_condition::Kind::positions;
    condition.targets = read_points(graph, vertices, target, traits);
    read_parameter(np, internal_np::position_weight, condition.weight);
    if constexpr (has_parameter<NamedParameters, CGAL::internal_np::vertex_normal_map_t>) {
      const auto normals = get_parameter(np, CGAL::internal_np::vertex_normal_map);
      condition.normals = read_vectors(graph, vertices, normals);
    } else {
      std::vector<int> all(static_cast<std::size_t>(mesh.size_of_vertices()));
      for (std::size_t v = 0; v < all.size(); ++v) all[v] = static_cast<int>(v);
      condition.normals = normals_at(mesh, read_points(graph, all, target, traits), vertices);
    }
  } else {
    condition.kind = Boundary_condition::Kind::directions;
    if constexpr (has_direction) {
      const Boundary_direction d = get_parameter(np, internal_np::boundary_direction);
      condition.direction = {d.tangent, d.normal, d.binormal};
    }
    if constexpr (has_targets)
      condition.targets =
          read_vectors(graph, vertices, get_parameter(np, internal_np::boundary_direction_map));
  }
  return condition;
}

}  // namespace internal
}  // namespace Conformal_geometry_processing
