// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "concepts/triangle_mesh_archetype.h"

#include <boost/property_map/property_map.hpp>

#include "concepts/geometry_traits_archetype.h"
#include "support/mesh_tools.h"

/// A generated mesh as a `archetype::Triangle_mesh`, and the least that property maps can do.
namespace cgp_test {

/// of the geometry traits: their points have coordinates in eighths
const double archetype_unit = 8;

inline archetype::Triangle_mesh archetype_of(const Mesh_view& view)
{
  archetype::Triangle_mesh mesh{at(view.size_of_vertices()), {}};
  for (const auto& v : view.corners()) mesh.corners.push_back({at(v[0]), at(v[1]), at(v[2])});
  return mesh;
}

/// the points of a view: readable, by value, not default constructible
struct Point_map_archetype {
  using key_type = archetype::Vertex;
  using value_type = Point_archetype;
  using reference = Point_archetype;
  using category = boost::readable_property_map_tag;

  explicit Point_map_archetype(const Mesh_view& mesh) : view(&mesh) {}
  const Mesh_view* view;

  friend Point_archetype get(const Point_map_archetype& map, archetype::Vertex v)
  {
    const Eigen::Vector3d p = map.view->position(static_cast<int>(v.number));
    const Geometry_traits_archetype traits(archetype_unit);
    return traits.construct_point_3_object()(p.x(), p.y(), p.z());
  }
};

/// points that can be written only
struct Output_map_archetype {
  using key_type = archetype::Vertex;
  using value_type = Point_archetype;
  using reference = void;
  using category = boost::writable_property_map_tag;

  explicit Output_map_archetype(Points& out) : points(&out) {}
  Points* points;

  friend void put(const Output_map_archetype& map, archetype::Vertex v, const Point_archetype& p)
  {
    const Geometry_traits_archetype traits(archetype_unit);
    map.points->col(static_cast<int>(v.number)) << traits.compute_x_3_object()(p),
        traits.compute_y_3_object()(p), traits.compute_z_3_object()(p);
  }
};

/// numbers of some kind that can be written only, into a vector
/// \tparam Key a descriptor \tparam Value converts to an entry of `Values`
template <class Key, class Value, class Values>
struct Writable_map_archetype {
  using key_type = Key;
  using value_type = Value;
  using reference = void;
  using category = boost::writable_property_map_tag;

  explicit Writable_map_archetype(Values& out) : values(&out) {}
  Values* values;

  friend void put(const Writable_map_archetype& map, Key key, const Value& value)
  {
    (*map.values)[static_cast<int>(key.number)] = typename Values::Scalar(value);
  }
};

}  // namespace cgp_test
