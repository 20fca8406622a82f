// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

/// A mesh outside of CGAL and without points, which supports only the requirements of the library
/// from the concepts `FaceListGraph` and `HalfedgeListGraph`.
namespace archetype {

struct Triangle_mesh {
  std::size_t size_of_vertices;
  std::vector<std::array<std::size_t, 3>> corners;
};

template <class Tag>
struct Descriptor {
  std::size_t number;
  friend bool operator==(Descriptor a, Descriptor b) { return a.number == b.number; }
  friend bool operator!=(Descriptor a, Descriptor b) { return !(a == b); }
  friend std::size_t hash_value(Descriptor d) { return d.number; }
};
using Vertex = Descriptor<struct Vertex_tag>;
using Halfedge = Descriptor<struct Halfedge_tag>;
using Face = Descriptor<struct Face_tag>;

template <class D>
std::vector<D> all(std::size_t n)
{
  std::vector<D> list;
  for (std::size_t i = 0; i < n; ++i) list.push_back(D{i});
  return list;
}

inline std::vector<Vertex> vertices(const Triangle_mesh& m)
{
  return all<Vertex>(m.size_of_vertices);
}
inline std::vector<Face> faces(const Triangle_mesh& m)
{
  return all<Face>(m.corners.size());
}

// halfedge 3 f + c leaves corner c of face f
inline Halfedge halfedge(Face f, const Triangle_mesh&)
{
  return {3 * f.number};
}
inline Halfedge next(Halfedge h, const Triangle_mesh&)
{
  return {h.number % 3 == 2 ? h.number - 2 : h.number + 1};
}
inline Vertex source(Halfedge h, const Triangle_mesh& m)
{
  return {m.corners[h.number / 3][h.number % 3]};
}
inline Vertex target(Halfedge h, const Triangle_mesh& m)
{
  return source(next(h, m), m);
}
// on the border, number 3 |F| + h
inline Halfedge opposite(Halfedge h, const Triangle_mesh& m)
{
  for (std::size_t g = 0; g < 3 * m.corners.size(); ++g)
    if (source({g}, m) == target(h, m) && target({g}, m) == source(h, m)) return {g};
  return {3 * m.corners.size() + h.number};
}

}  // namespace archetype

namespace std {
template <class Tag>
struct hash<archetype::Descriptor<Tag>> {
  size_t operator()(archetype::Descriptor<Tag> d) const { return d.number; }
};
}  // namespace std

namespace boost {
template <>
struct graph_traits<archetype::Triangle_mesh> {
  using vertex_descriptor = archetype::Vertex;
  using halfedge_descriptor = archetype::Halfedge;
  using face_descriptor = archetype::Face;
};
}  // namespace boost
