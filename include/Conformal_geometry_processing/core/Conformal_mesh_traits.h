// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/core/geometry_traits.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/boost/graph/properties.h>
#include <boost/functional/hash.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

/// \brief Numbers the current vertices or faces of a mesh, for meshes whose elements have no
/// indices. One hash table look-up per access.
///
/// \tparam Descriptor can be compared and hashed by `boost::hash`
template <class Descriptor>
class Element_numbering {
 public:
  template <class Range>
  explicit Element_numbering(const Range& elements)
  {
    for (const auto& e : elements) m_numbers.emplace(e, m_numbers.size());
  }

  std::size_t size() const { return m_numbers.size(); }

  /// \throw Precondition_error if the element was added to the mesh later
  std::size_t operator()(const Descriptor& element) const
  {
    const auto found = m_numbers.find(element);
    if (found == m_numbers.end())
      throw Precondition_error("Associated_property_map",
                               "the element was added to the mesh after the map was made; make the "
                               "map when the mesh is complete");
    return found->second;
  }

 private:
  std::unordered_map<Descriptor, std::size_t, boost::hash<Descriptor>> m_numbers;
};

/// \brief A property map that owns its values, outside the mesh; copies share them.
///
/// A model of `LvaluePropertyMap`. Several maps may share one numbering. Elements are identified by
/// their `Descriptor`: if it is an address, an element that replaces an erased one inherits its
/// value.
template <class Descriptor, class Value>
class Associated_property_map {
 public:
  using key_type = Descriptor;
  using value_type = Value;
  using reference = Value&;
  using category = boost::lvalue_property_map_tag;

  Associated_property_map() = default;

  Associated_property_map(std::shared_ptr<const Element_numbering<Descriptor>> numbering,
                          const Value& initial)
      : m_numbering(std::move(numbering)),
        m_values(std::make_shared<std::vector<Value>>(m_numbering->size(), initial))
  {}

  reference operator[](const key_type& key) const { return (*m_values)[(*m_numbering)(key)]; }

  friend reference get(const Associated_property_map& map, const key_type& key) { return map[key]; }
  friend void put(const Associated_property_map& map, const key_type& key, const value_type& value)
  {
    map[key] = value;
  }

 private:
  std::shared_ptr<const Element_numbering<Descriptor>> m_numbering;
  std::shared_ptr<std::vector<Value>> m_values;
};

}  // namespace internal

/// \ingroup PkgMesh
/// \brief Provides property maps for the curvature potential rho, the spin lambda and the normals
/// of a mesh, so that a pipeline needs no map of its own.
///
/// The default for any mesh uses dynamic property maps, whose values are shared by all copies.
/// Headers for some mesh types specialize it: `Surface_mesh` keeps the maps in the mesh,
/// `Polyhedron_3` gets containers outside the mesh. Specialize it for your own mesh type as a model
/// of `ConformalMeshTraits`. The constructor costs O(|V| + |F|).
///
/// \tparam TriangleMesh a model of `FaceListGraph` whose vertices have points
/// \cgalModels{ConformalMeshTraits}
template <class TriangleMesh>
class Conformal_mesh_traits {
  using Graph_traits = boost::graph_traits<TriangleMesh>;
  template <class Tag>
  using Map = typename boost::property_map<TriangleMesh, Tag>::const_type;
  using Points_of_mesh =
      typename boost::property_map<TriangleMesh, boost::vertex_point_t>::const_type;
  using Point = typename boost::property_traits<Points_of_mesh>::value_type;
  using Vector = internal::Vector_of<Point>;
  using Spin = Quaternion<double>;

 public:
  using Triangle_mesh = TriangleMesh;
  using Vertex_curvature_potential_map = Map<CGAL::dynamic_vertex_property_t<double>>;
  using Face_curvature_potential_map = Map<CGAL::dynamic_face_property_t<double>>;
  using Vertex_spin_map = Map<CGAL::dynamic_vertex_property_t<Spin>>;
  using Vertex_normal_map = Map<CGAL::dynamic_vertex_property_t<Vector>>;

  /// Creates the maps: rho = 0, lambda = 1, normals 0
  /// \param mesh is not changed and must outlive the maps
  explicit Conformal_mesh_traits(const TriangleMesh& mesh)
      : m_vertex_rho(get(CGAL::dynamic_vertex_property_t<double>(), mesh)),
        m_face_rho(get(CGAL::dynamic_face_property_t<double>(), mesh)),
        m_spin(get(CGAL::dynamic_vertex_property_t<Spin>(), mesh)),
        m_normal(get(CGAL::dynamic_vertex_property_t<Vector>(), mesh))
  {
    for (const auto v : vertices(mesh)) {
      put(m_vertex_rho, v, 0.);
      put(m_spin, v, Spin{1, 0, 0, 0});
      put(m_normal, v, Vector(0, 0, 0));
    }
    for (const auto f : faces(mesh)) put(m_face_rho, f, 0.);
  }

  /// The maps; copies share their values
  Vertex_curvature_potential_map vertex_curvature_potential_map() const { return m_vertex_rho; }
  Face_curvature_potential_map face_curvature_potential_map() const { return m_face_rho; }
  Vertex_spin_map vertex_spin_map() const { return m_spin; }
  Vertex_normal_map vertex_normal_map() const { return m_normal; }

 private:
  Vertex_curvature_potential_map m_vertex_rho;
  Face_curvature_potential_map m_face_rho;
  Vertex_spin_map m_spin;
  Vertex_normal_map m_normal;
};

}  // namespace Conformal_geometry_processing
