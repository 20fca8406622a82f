// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/with_opened_faces.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <set>

namespace Conformal_geometry_processing {

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
