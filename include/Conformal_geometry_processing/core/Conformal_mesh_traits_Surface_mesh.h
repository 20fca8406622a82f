// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/Conformal_mesh_traits.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <string>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgMesh
/// \brief Keeps rho, lambda and the normals in the mesh, as its properties `v:rho`, `f:rho`,
/// `v:lambda` and `v:normal`.
///
/// Existing properties are used with their values, so values persist from one stage of a pipeline
/// to the next, and follow the mesh when it is copied, edited or garbage-collected.
/// A program that includes this header uses `CGAL::Surface_mesh`, which is under the GPL.
///
/// \cgalModels{ConformalMeshTraits}
template <class Point>
class Conformal_mesh_traits<CGAL::Surface_mesh<Point>> {
  using Spin = Quaternion<double>;
  using Vector = internal::Vector_of<Point>;

 public:
  using Triangle_mesh = CGAL::Surface_mesh<Point>;

 private:
  using Vertex = typename Triangle_mesh::Vertex_index;
  using Face = typename Triangle_mesh::Face_index;

 public:
  using Vertex_curvature_potential_map =
      typename Triangle_mesh::template Property_map<Vertex, double>;
  using Face_curvature_potential_map = typename Triangle_mesh::template Property_map<Face, double>;
  using Vertex_spin_map = typename Triangle_mesh::template Property_map<Vertex, Spin>;
  using Vertex_normal_map = typename Triangle_mesh::template Property_map<Vertex, Vector>;

  /// Finds or adds the properties: rho = 0, lambda = 1, normals 0
  /// \param mesh must outlive the maps
  /// \throw Precondition_error if one of the four names belongs to a property of another type
  explicit Conformal_mesh_traits(Triangle_mesh& mesh)
      : m_vertex_rho(property<Vertex>(mesh, "v:rho", 0.)),
        m_face_rho(property<Face>(mesh, "f:rho", 0.)),
        m_spin(property<Vertex>(mesh, "v:lambda", Spin{1, 0, 0, 0})),
        m_normal(property<Vertex>(mesh, "v:normal", Vector(0, 0, 0)))
  {}

  /// The maps, which refer to the properties of the mesh
  Vertex_curvature_potential_map vertex_curvature_potential_map() const { return m_vertex_rho; }
  Face_curvature_potential_map face_curvature_potential_map() const { return m_face_rho; }
  Vertex_spin_map vertex_spin_map() const { return m_spin; }
  Vertex_normal_map vertex_normal_map() const { return m_normal; }

 private:
  // Surface_mesh would add a second property of the same name if one of another type exists, such
  // as float from a file reader, and the values of the user would be ignored silently.
  template <class Key, class Value>
  static auto property(Triangle_mesh& mesh, const std::string& name, const Value& initial)
  {
    const std::vector<std::string> names = mesh.template properties<Key>();
    const bool is_taken = std::find(names.begin(), names.end(), name) != names.end();
    auto [map, is_new] = mesh.template add_property_map<Key, Value>(name, initial);
    if (is_taken && is_new) {
      mesh.remove_property_map(map);
      throw Precondition_error("Conformal_mesh_traits",
                               "the mesh has a property " + name + " of another type; rename it");
    }
    return map;
  }

  Vertex_curvature_potential_map m_vertex_rho;
  Face_curvature_potential_map m_face_rho;
  Vertex_spin_map m_spin;
  Vertex_normal_map m_normal;
};

}  // namespace Conformal_geometry_processing
