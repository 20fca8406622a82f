// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/Graph_view.h>
#include <Conformal_geometry_processing/core/named_parameters.h>
#include <Conformal_geometry_processing/spin/Spin_transformation_options.h>

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
  if constexpr (has_parameter<NamedParameters, internal_np::scale_bound_t>)
    control.bound = get_parameter(np, internal_np::scale_bound);
  else
    control.bound = default_bound(options);
}

}  // namespace Conformal_geometry_processing::internal
