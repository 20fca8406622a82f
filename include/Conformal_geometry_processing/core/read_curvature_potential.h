// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/Graph_view.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>

#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <Eigen/Core>

#include <type_traits>
#include <utility>

namespace Conformal_geometry_processing::internal {

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
  const Mesh_view& mesh = graph.view();
  Eigen::VectorXd values(on_vertices ? mesh.size_of_vertices() : mesh.size_of_faces());
  for (int i = 0; i < values.size(); ++i) {
    if constexpr (on_vertices)
      values[i] = CGAL::to_double(get(rho, graph.vertex(i)));
    else
      values[i] = CGAL::to_double(get(rho, graph.face(i)));
  }
  return {on_vertices ? Curvature_potential::On::vertices : Curvature_potential::On::faces,
          std::move(values)};
}

}  // namespace Conformal_geometry_processing::internal
