// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/simple_delaunay.h>

#include <Conformal_geometry_processing/mesh/Intrinsic_triangulation.h>
#include <Conformal_geometry_processing/mesh/requirements.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
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

Mesh_view internal::simple_delaunay(const Mesh_view& mesh, double mollification,
                                    std::vector<std::array<int, 2>>* flips)
{
  Intrinsic_triangulation triangles(mesh, mollification > 0
                                              ? mollified_lengths(mesh, mollification).lengths
                                              : edge_lengths(mesh));
  Joined_vertices joined(mesh);
  const auto may_flip = [&](int h) {
    const int k = triangles.apex(h), l = triangles.apex(triangles.twin(h));
    return k != l && !joined.contain(k, l) && has_area_when_flipped(mesh, triangles, h);
  };
  const auto flipped = [&](int h) {
    if (flips) flips->push_back({triangles.from(h), triangles.to(h)});
    joined.flip(triangles, h);
  };
  if (flip_to_delaunay(triangles, may_flip, flipped) == 0) return mesh;
  Mesh_view::Corners corners(static_cast<std::size_t>(mesh.size_of_faces()));
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    corners[static_cast<std::size_t>(f)] = {triangles.apex(3 * f), triangles.apex(3 * f + 1),
                                            triangles.apex(3 * f + 2)};
  return {mesh.positions(), std::move(corners)};
}

Mesh_view internal::delaunay_by_chords(Mesh_view mesh, double mollification,
                                       std::vector<std::array<int, 2>>& flips)
{
  const int most_rounds = 20;
  for (int round = 0; round < most_rounds; ++round) {
    const std::size_t before = flips.size();
    mesh = simple_delaunay(mesh, mollification, &flips);
    if (flips.size() == before) break;
  }
  return mesh;
}

namespace internal {

/// the vertices opposite to long edges of thin faces: the tip of a cap, both ends of a needle
inline std::set<int> tips_of_thin_faces(const Mesh_view& mesh, double share)
{
  const double is_long = .75;  // by the longest
  std::set<int> tips;
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    Eigen::Vector3d l;
    for (int c = 0; c < 3; ++c) l[c] = mesh.vector(3 * f + c).stableNorm();
    const double longest = l.maxCoeff();
    if (l.sum() - 2 * longest >= share * longest && longest > 0) continue;
    for (int c = 0; c < 3; ++c)
      if (l[c] >= is_long * longest) tips.insert(mesh.corners(f)[static_cast<std::size_t>(c)]);
  }
  return tips;
}

/// the sums of the vectors from the vertices to their neighbours, over all faces, and of the
/// normals
struct Vertex_surroundings {
  explicit Vertex_surroundings(const Mesh_view& mesh)
      : to_neighbours(Points::Zero(3, mesh.size_of_vertices())),
        normals(to_neighbours),
        counts(Eigen::VectorXd::Zero(mesh.size_of_vertices()))
  {
    for (int h = 0; h < mesh.size_of_halfedges(); ++h) {
      const int from = mesh.from(h), to = mesh.to(h);
      to_neighbours.col(from) += mesh.vector(h);
      to_neighbours.col(to) -= mesh.vector(h);
      counts[from] += 1, counts[to] += 1;
      normals.col(from) += mesh.double_area_vector(Mesh_view::face(h));
    }
  }

  /// to the mean of the neighbours, along the surface
  Eigen::Vector3d way_in(int v) const
  {
    const Eigen::Vector3d way = to_neighbours.col(v) / counts[v],
                          normal = normals.col(v).stableNormalized();
    return way - way.dot(normal) * normal;
  }

  Points to_neighbours, normals;
  Eigen::VectorXd counts;
};

}  // namespace internal

Mesh_view internal::with_opened_faces(const Mesh_view& mesh, double share)
{
  const int passes = 20;  // a few are enough where one vertex can be moved out of the way
  Mesh_view opened = mesh;
  for (int pass = 0; pass < passes; ++pass) {
    const std::set<int> tips = tips_of_thin_faces(opened, share);
    if (tips.empty()) break;
    const Vertex_surroundings surroundings(opened);
    Points moved = opened.positions();
    for (const int v : tips) moved.col(v) += std::sqrt(share) * surroundings.way_in(v);
    opened.set_positions(moved);
  }
  return opened;
}

}  // namespace Conformal_geometry_processing
