// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <cmath>

namespace cgp_benchmark {

namespace CGP = Conformal_geometry_processing;

/// the positions with the centroid of the surface at the origin and area 4 pi, in one pass over the
/// faces: it is done after every step, of which explicit methods make many
inline CGP::Points positions_in_unit_frame(const CGP::Mesh_view& mesh)
{
  double area = 0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const auto& [a, b, c] = mesh.corners(f);
    const double share = mesh.double_area_vector(f).norm() / 2;
    area += share;
    moment += share / 3 * (mesh.position(a) + mesh.position(b) + mesh.position(c));
  }
  const double scale = std::sqrt(4 * std::acos(-1.) / area);
  return scale * (mesh.positions().colwise() - moment / area);
}

}  // namespace cgp_benchmark
