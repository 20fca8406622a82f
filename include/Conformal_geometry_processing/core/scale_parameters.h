// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/Graph_view.h>
#include <Conformal_geometry_processing/core/named_parameters.h>
#include <Conformal_geometry_processing/spin/Scale_control.h>

#include <CGAL/number_utils.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing::internal {

/// the numbers of a map with one per vertex, in the order of the view
template <class TriangleMesh, class VertexNumberMap>
Eigen::VectorXd read_vertex_numbers(const Graph_view<TriangleMesh>& graph, VertexNumberMap map)
{
  Eigen::VectorXd numbers(graph.view().size_of_vertices());
  for (int v = 0; v < numbers.size(); ++v) numbers[v] = CGAL::to_double(get(map, graph.vertex(v)));
  return numbers;
}

/// what `scale_bound`, `vertex_scale_map` and `vertex_scale_weight_map` specify
template <class TriangleMesh, class NamedParameters>
Scale_control scale_control(const Graph_view<TriangleMesh>& graph, const NamedParameters& np)
{
  using CGAL::parameters::get_parameter;
  Scale_control control;
  if constexpr (has_parameter<NamedParameters, internal_np::scale_bound_t>)
    control.bound = get_parameter(np, internal_np::scale_bound);
  if constexpr (has_parameter<NamedParameters, internal_np::vertex_scale_map_t>)
    control.factors = read_vertex_numbers(graph, get_parameter(np, internal_np::vertex_scale_map));
  if constexpr (has_parameter<NamedParameters, internal_np::vertex_scale_weight_map_t>)
    control.weights =
        read_vertex_numbers(graph, get_parameter(np, internal_np::vertex_scale_weight_map));
  return control;
}

}  // namespace Conformal_geometry_processing::internal
