// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace cgp_test {

/// adds the vertices and faces of a view to a mesh of any CGAL type, in their order
/// \tparam Mesh a model of `MutableFaceGraph` with a vertex point map
template <class Mesh>
void add_to_cgal_mesh(const Conformal_geometry_processing::Mesh_view& view, Mesh& mesh)
{
  using vertex_descriptor = typename boost::graph_traits<Mesh>::vertex_descriptor;
  auto points = get(CGAL::vertex_point, mesh);
  using Point = typename boost::property_traits<decltype(points)>::value_type;
  std::vector<vertex_descriptor> vertex;
  for (int v = 0; v < view.size_of_vertices(); ++v) {
    vertex.push_back(add_vertex(mesh));
    const Eigen::Vector3d p = view.position(v);
    put(points, vertex.back(), Point(p.x(), p.y(), p.z()));
  }
  for (const auto& c : view.corners()) {
    const std::array<vertex_descriptor, 3> face = {vertex[static_cast<std::size_t>(c[0])],
                                                   vertex[static_cast<std::size_t>(c[1])],
                                                   vertex[static_cast<std::size_t>(c[2])]};
    if (CGAL::Euler::add_face(face, mesh) == boost::graph_traits<Mesh>::null_face())
      throw std::logic_error("a face does not fit into the mesh");
  }
}

/// the view as a mesh of a CGAL type
template <class Mesh>
Mesh to_cgal_mesh(const Conformal_geometry_processing::Mesh_view& view)
{
  Mesh mesh;
  add_to_cgal_mesh(view, mesh);
  return mesh;
}

}  // namespace cgp_test
