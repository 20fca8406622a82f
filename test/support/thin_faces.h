// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef TEST_SUPPORT_THIN_FACES_H
#define TEST_SUPPORT_THIN_FACES_H

#include <utility>
#include <vector>

#include "support/mesh_tools.h"

/// Good meshes spoilt: the same surface in faces as thin as one likes.
namespace cgp_test {

/// \brief the mesh with a new vertex in every third face, near the edge from its first corner to
/// the second; the vertices of the mesh come first.
/// \param height above the edge, relative to its length: of a cap; zero makes a face of area zero
/// \param where along the edge, from 0 (the first corner: a needle) to 1
/// \param fold how much of the height is along the normal, too
inline Mesh_view with_thin_faces(const Mesh_view& mesh, double height, double where = .5,
                                 double fold = 0)
{
  Corners corners = mesh.corners();
  std::vector<Eigen::Vector3d> added;
  for (int f = 0; f < mesh.size_of_faces(); f += 3) {
    const auto v = mesh.corners(f);
    const Eigen::Vector3d edge = mesh.vector(3 * f + 2),
                          n = mesh.double_area_vector(f).normalized();
    added.push_back(mesh.position(v[0]) + where * edge +
                    height * (n.cross(edge) + fold * edge.norm() * n));
    const int apex = mesh.size_of_vertices() + static_cast<int>(added.size()) - 1;
    corners[at(f)] = {v[0], v[1], apex};
    corners.push_back({v[1], v[2], apex});
    corners.push_back({v[2], v[0], apex});
  }
  Points p(3, mesh.size_of_vertices() + static_cast<int>(added.size()));
  p.leftCols(mesh.size_of_vertices()) = mesh.positions();
  for (std::size_t i = 0; i < added.size(); ++i)
    p.col(mesh.size_of_vertices() + static_cast<int>(i)) = added[i];
  return {std::move(p), std::move(corners)};
}

/// caps, needles and faces of area zero together, and folded ones
inline Mesh_view spoilt(const Mesh_view& mesh)
{
  return with_thin_faces(with_thin_faces(with_thin_faces(mesh, 1e-9), 1e-7, 1e-3, -2), 0, .3);
}

}  // namespace cgp_test

#endif
