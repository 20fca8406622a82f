// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/Graph_view.h>
#include <Conformal_geometry_processing/core/Quaternion_access.h>
#include <Conformal_geometry_processing/core/named_parameters.h>
#include <Conformal_geometry_processing/core/write_points.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <boost/property_map/property_map.hpp>

namespace Conformal_geometry_processing::internal {

/// the limits of the named parameters, if there are any
template <class NamedParameters>
void read_limits(const NamedParameters& np, Spin_report::Limits& limits)
{
  if constexpr (has_parameter<NamedParameters, internal_np::limits_t>)
    limits = CGAL::parameters::get_parameter(np, internal_np::limits);
}

/// Writes lambda, then the points. A map that throws leaves the points as they were
/// (`write_points()`).
template <class TriangleMesh, class NamedParameters>
void write_spin_result(TriangleMesh& mesh, const Graph_view<TriangleMesh>& graph,
                       const Spin_result& result, const NamedParameters& np)
{
  if constexpr (has_parameter<NamedParameters, internal_np::vertex_spin_map_t>) {
    auto spins = CGAL::parameters::get_parameter(np, internal_np::vertex_spin_map);
    using Value = typename boost::property_traits<decltype(spins)>::value_type;
    for (int v = 0; v < graph.view().size_of_vertices(); ++v)
      put(spins, graph.vertex(v), Quaternion_access<Value>::to(result.lambda[v]));
  }
  write_points(mesh, graph, result.positions, np);
}

}  // namespace Conformal_geometry_processing::internal
