// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/Graph_view.h>
#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/spin/Control_point.h>

#include <CGAL/number_utils.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <string>
#include <type_traits>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \brief the index of a vertex in the view. Only compares descriptors, because what is no vertex
/// of the mesh has no entry in a property map. \param k the target that is for it, named in the
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
      const Eigen::Vector3d target(CGAL::to_double(traits.compute_x_3_object()(to)),
                                   CGAL::to_double(traits.compute_y_3_object()(to)),
                                   CGAL::to_double(traits.compute_z_3_object()(to)));
      points.push_back(
          control_point(index_of<TriangleMesh, Vertex>(graph, where, k, function), target));
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

}  // namespace Conformal_geometry_processing::internal
