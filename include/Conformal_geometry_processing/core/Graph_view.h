// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/geometry_traits.h>
#include <Conformal_geometry_processing/mesh/Mesh_component.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/boost/graph/properties.h>
#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgMesh
/// \brief The `Mesh_view` of a mesh, with the descriptors of its vertices and faces.
///
/// Numbers the *live* vertices and faces in the order of `vertices(mesh)` and `faces(mesh)`,
/// because `num_vertices()` and the index maps include removed elements. Accesses the mesh only
/// once, because the dynamic property maps of some meshes are hash maps. O(|V| + |F|).
///
/// \tparam TriangleMesh see \ref triangle_mesh_requirements
template <class TriangleMesh>
class Graph_view {
  using Graph_traits = boost::graph_traits<TriangleMesh>;

 public:
  using vertex_descriptor = typename Graph_traits::vertex_descriptor;
  using face_descriptor = typename Graph_traits::face_descriptor;

  /// Reads the points and the traits given by named parameters, or else those of the mesh
  template <class NamedParameters>
  Graph_view(const TriangleMesh& mesh, const NamedParameters& np, const std::string& function)
      : Graph_view(mesh, internal::vertex_points(mesh, np),
                   internal::geometry_traits<TriangleMesh>(np), function)
  {}

  /// \param mesh is only read, and not stored
  /// \param points a readable map from vertices to points
  /// \param traits a model of `ConformalGeometryTraits_3`, which accesses the coordinates of a
  /// point
  /// \param function named in the exception
  /// \throw Precondition_error if a face is not a
  /// triangle
  template <class VertexPointMap, class GeomTraits>
  Graph_view(const TriangleMesh& mesh, VertexPointMap points, const GeomTraits& traits,
             const std::string& function)
  {
    static_assert(internal::is_conformal_geometry_traits<GeomTraits>,
                  "geom_traits is not a model of ConformalGeometryTraits_3");
    auto number = get(CGAL::dynamic_vertex_property_t<int>(), mesh);
    for (vertex_descriptor v : vertices(mesh)) {
      put(number, v, static_cast<int>(m_vertices.size()));
      m_vertices.push_back(v);
    }
    Mesh_view::Corners corners;
    for (face_descriptor f : faces(mesh)) {
      const auto h = halfedge(f, mesh);
      const auto g = next(h, mesh);
      if (next(next(g, mesh), mesh) != h)
        throw Precondition_error(function, "face " + std::to_string(m_faces.size()) +
                                               " is not a triangle; triangulate the mesh first");
      corners.push_back({get(number, source(h, mesh)), get(number, target(h, mesh)),
                         get(number, target(g, mesh))});
      m_faces.push_back(f);
    }
    m_view = Mesh_view(coordinates(points, traits), std::move(corners));
  }

  /// The view of one component of the mesh, as if it were the whole mesh
  Graph_view(const Graph_view& whole, internal::Mesh_component component)
      : m_view(std::move(component.mesh))
  {
    for (const int v : component.vertices) m_vertices.push_back(whole.vertex(v));
    for (const int f : component.faces) m_faces.push_back(whole.face(f));
  }

  const Mesh_view& view() const { return m_view; }

  /// The vertex with index v, and the face with index f
  vertex_descriptor vertex(int v) const { return m_vertices[static_cast<std::size_t>(v)]; }
  face_descriptor face(int f) const { return m_faces[static_cast<std::size_t>(f)]; }

  /// Writes a point for each vertex to a map
  /// \param positions 3 x |V|
  template <class VertexPointMap, class GeomTraits>
  void write_positions(const Points& positions, VertexPointMap points,
                       const GeomTraits& traits) const
  {
    using FT = typename GeomTraits::FT;
    const auto point = traits.construct_point_3_object();
    for (Eigen::Index v = 0; v < positions.cols(); ++v)
      put(points, vertex(static_cast<int>(v)),
          point(FT(positions(0, v)), FT(positions(1, v)), FT(positions(2, v))));
  }

 private:
  template <class VertexPointMap, class GeomTraits>
  Points coordinates(VertexPointMap points, const GeomTraits& traits) const
  {
    Points positions(3, static_cast<Eigen::Index>(m_vertices.size()));
    for (std::size_t v = 0; v < m_vertices.size(); ++v)
      positions.col(static_cast<Eigen::Index>(v)) =
          internal::coordinates_of(get(points, m_vertices[v]), traits);
    return positions;
  }

  Mesh_view m_view;
  std::vector<vertex_descriptor> m_vertices;
  std::vector<face_descriptor> m_faces;
};

namespace internal {

/// \brief Calls `work(graph)` with a view of each component in turn, and `take(vertices, result)`
/// with the indices of its vertices in the whole mesh and the result, which has a `report`.
///
/// All components are created first; the memory of each one is released before the next one begins.
/// \throw Precondition_error, Solver_error see `Component_failures`
template <class TriangleMesh, class Work, class Take>
auto for_each_component(const Graph_view<TriangleMesh>& whole, const std::string& function,
                        const Work& work, const Take& take)
{
  using Report = decltype(work(whole).report);
  std::vector<Mesh_component> parts = mesh_components(whole.view());
  Component_failures failures(parts.size(), function);
  Component_reports<Report> all;
  for (std::size_t c = 0; c < parts.size(); ++c) {
    const std::vector<int> vertices = parts[c].vertices;
    const Graph_view<TriangleMesh> component(whole, std::move(parts[c]));
    failures.attempt(c, vertices.front(), [&] {
      auto result = work(component);
      take(vertices, result);
      all.components.push_back({vertices.front(), component.view().size_of_vertices(),
                                component.view().size_of_faces(), std::move(result.report)});
    });
  }
  failures.throw_if_any();
  return all;
}

}  // namespace internal

}  // namespace Conformal_geometry_processing
