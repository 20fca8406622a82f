// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/Graph_view.h>
#include <Conformal_geometry_processing/core/geometry_traits.h>
#include <Conformal_geometry_processing/core/named_parameters.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// Writes the positions, 3 x |V|, to the output given by named parameters. If a map throws, the
/// points are restored, unless they are written to a separate output map.
template <class TriangleMesh, class NamedParameters>
void write_points(TriangleMesh& mesh, const Graph_view<TriangleMesh>& graph,
                  const Points& positions, const NamedParameters& np)
{
  const auto points = output_vertex_points(mesh, np);
  const auto traits = geometry_traits<TriangleMesh>(np);
  if constexpr (has_parameter<NamedParameters, internal_np::output_vertex_point_map_t>) {
    graph.write_positions(positions, points, traits);
  } else {
    std::vector<typename boost::property_traits<std::decay_t<decltype(points)>>::value_type> old;
    for (int v = 0; v < graph.view().size_of_vertices(); ++v)
      old.push_back(get(points, graph.vertex(v)));
    try {
      graph.write_positions(positions, points, traits);
    } catch (...) {
      for (int v = 0; v < graph.view().size_of_vertices(); ++v)
        put(points, graph.vertex(v), old[static_cast<std::size_t>(v)]);
      throw;
    }
  }
}

}  // namespace Conformal_geometry_processing::internal
