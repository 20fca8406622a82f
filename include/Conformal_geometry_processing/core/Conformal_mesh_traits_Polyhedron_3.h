// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/Conformal_mesh_traits.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

#include <memory>

namespace Conformal_geometry_processing {

/// \ingroup PkgMesh
/// \brief Containers for rho, lambda and the normals outside a `Polyhedron_3`, with items of any
/// kind: `id()` is neither required nor modified.
///
/// The maps contain the vertices and faces that the mesh had at construction of the traits, and
/// stay valid as long as one of their copies exists. The maps on vertices share one numbering.
/// A program that includes this header uses `CGAL::Polyhedron_3`, which is under the GPL.
///
/// \cgalModels{ConformalMeshTraits}
template <class Kernel, class Items, template <class, class, class> class HDS, class Allocator>
class Conformal_mesh_traits<CGAL::Polyhedron_3<Kernel, Items, HDS, Allocator>> {
 public:
  using Triangle_mesh = CGAL::Polyhedron_3<Kernel, Items, HDS, Allocator>;

 private:
  using Graph_traits = boost::graph_traits<Triangle_mesh>;
  using Vertex = typename Graph_traits::vertex_descriptor;
  using Face = typename Graph_traits::face_descriptor;
  using Vertex_numbering = std::shared_ptr<const internal::Element_numbering<Vertex>>;
  using Spin = Quaternion<double>;
  using Vector = internal::Vector_of<typename Triangle_mesh::Point_3>;

 public:
  using Vertex_curvature_potential_map = internal::Associated_property_map<Vertex, double>;
  using Face_curvature_potential_map = internal::Associated_property_map<Face, double>;
  using Vertex_spin_map = internal::Associated_property_map<Vertex, Spin>;
  using Vertex_normal_map = internal::Associated_property_map<Vertex, Vector>;

  /// Creates the containers: rho = 0, lambda = 1, normals 0
  /// \param mesh is not changed and must outlive the maps; O(|V| + |F|)
  explicit Conformal_mesh_traits(const Triangle_mesh& mesh)
      : Conformal_mesh_traits(
            mesh, std::make_shared<const internal::Element_numbering<Vertex>>(vertices(mesh)))
  {}

  /// The maps; copies share their values
  Vertex_curvature_potential_map vertex_curvature_potential_map() const { return m_vertex_rho; }
  Face_curvature_potential_map face_curvature_potential_map() const { return m_face_rho; }
  Vertex_spin_map vertex_spin_map() const { return m_spin; }
  Vertex_normal_map vertex_normal_map() const { return m_normal; }

 private:
  Conformal_mesh_traits(const Triangle_mesh& mesh, const Vertex_numbering& numbering)
      : m_vertex_rho(numbering, 0.),
        m_face_rho(std::make_shared<const internal::Element_numbering<Face>>(faces(mesh)), 0.),
        m_spin(numbering, Spin{1, 0, 0, 0}),
        m_normal(numbering, Vector(0, 0, 0))
  {}

  Vertex_curvature_potential_map m_vertex_rho;
  Face_curvature_potential_map m_face_rho;
  Vertex_spin_map m_spin;
  Vertex_normal_map m_normal;
};

}  // namespace Conformal_geometry_processing
