// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// A user's program over the kernels alone, compiled with the flags of pkg-config.
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <cmath>
#include <iostream>

namespace CGP = Conformal_geometry_processing;

// A regular octahedron and no change of curvature: all edges stay equal.
int main()
{
  CGP::Points points(3, 6);
  points << 1, -1, 0, 0, 0, 0, 0, 0, 1, -1, 0, 0, 0, 0, 0, 0, 1, -1;
  const CGP::Mesh_view mesh(
      points,
      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}});
  const auto rho = CGP::Curvature_potential::on_vertices(Eigen::VectorXd::Zero(6));
  const CGP::Spin_result result = CGP::Spin_transformation(mesh).transform(rho);
  double change = 0;
  for (const auto& face : mesh.corners())
    for (int k = 0; k < 3; ++k) {
      const auto edge = result.positions.col(face[k]) - result.positions.col(face[(k + 1) % 3]);
      change = std::max(change, std::abs(edge.norm() / std::sqrt(2.) - 1));
    }
  std::cout << "kernels by pkg-config, lengths change by " << change << '\n';
  return change < 1e-9 ? 0 : 1;
}
