// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/simple_delaunay.h>

#include <Conformal_geometry_processing/mesh/Intrinsic_triangulation.h>
#include <Conformal_geometry_processing/mesh/intrinsic_delaunay.h>
#include <Conformal_geometry_processing/mesh/mollified_lengths.h>
#include <Conformal_geometry_processing/mesh/requirements.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <utility>

namespace Conformal_geometry_processing {

namespace internal {

/// \ingroup PkgMesh
/// The pairs of vertices that the edges of a triangulation join
class Joined_vertices {
 public:
  explicit Joined_vertices(const Mesh_view& mesh) : m_pairs(mesh.ends().begin(), mesh.ends().end())
  {}

  bool contain(int a, int b) const { return m_pairs.count({(std::min)(a, b), (std::max)(a, b)}); }

  void flip(const Intrinsic_triangulation& triangles, int h)
  {
    const auto pair = [](int a, int b) {
      return std::array<int, 2>{(std::min)(a, b), (std::max)(a, b)};
    };
    m_pairs.erase(pair(triangles.from(h), triangles.to(h)));
    m_pairs.insert(pair(triangles.apex(h), triangles.apex(triangles.twin(h))));
  }

 private:
  std::set<std::array<int, 2>> m_pairs;
};

// Whether the chords of the two faces after a flip enclose an area.
inline bool has_area_when_flipped(const Mesh_view& mesh, const Intrinsic_triangulation& triangles,
                                  int h)
{
  const int k = triangles.apex(h), l = triangles.apex(triangles.twin(h));
  for (const int v : {triangles.from(h), triangles.to(h)}) {
    Eigen::Matrix3d edges;
    edges << mesh.position(v) - mesh.position(l), mesh.position(k) - mesh.position(v),
        mesh.position(l) - mesh.position(k);
    if (has_area_zero(edges)) return false;
  }
  return true;
}

}  // namespace internal

Mesh_view internal::simple_delaunay(const Mesh_view& mesh, double mollification)
{
  Intrinsic_triangulation triangles(mesh, mollification > 0
                                              ? mollified_lengths(mesh, mollification).lengths
                                              : edge_lengths(mesh));
  Joined_vertices joined(mesh);
  const auto may_flip = [&](int h) {
    const int k = triangles.apex(h), l = triangles.apex(triangles.twin(h));
    return k != l && !joined.contain(k, l) && has_area_when_flipped(mesh, triangles, h);
  };
  const int flips =
      flip_to_delaunay(triangles, may_flip, [&](int h) { joined.flip(triangles, h); });
  if (flips == 0) return mesh;
  Mesh_view::Corners corners(static_cast<std::size_t>(mesh.size_of_faces()));
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    corners[static_cast<std::size_t>(f)] = {triangles.apex(3 * f), triangles.apex(3 * f + 1),
                                            triangles.apex(3 * f + 2)};
  return {mesh.positions(), std::move(corners)};
}

}  // namespace Conformal_geometry_processing
