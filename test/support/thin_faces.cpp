// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "support/thin_faces.h"

namespace cgp_test {

Mesh_view with_thin_faces(const Mesh_view& mesh, double height, double where, double fold)
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

Mesh_view spoilt(const Mesh_view& mesh)
{
  return with_thin_faces(with_thin_faces(with_thin_faces(mesh, 1e-9), 1e-7, 1e-3, -2), 0, .3);
}

}  // namespace cgp_test
