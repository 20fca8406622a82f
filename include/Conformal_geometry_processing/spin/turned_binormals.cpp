// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/turned_binormals.h>

#include <Conformal_geometry_processing/mesh/Boundary_frames.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>

namespace Conformal_geometry_processing {

Points turned_binormals(const Mesh_view& from, const Mesh_view& to, const Mesh_view& start,
                        double t)
{
  const internal::Boundary_frames F = boundary_frames(from), G = boundary_frames(to),
                                  S = boundary_frames(start);
  Points turned(3, static_cast<Eigen::Index>(S.vertices.size()));
  for (std::size_t k = 0; k < S.vertices.size(); ++k) {
    const Eigen::Vector3d end = F.frames[k].transpose() * G.binormal(k);
    const double sine = std::hypot(end.x(), end.y()), angle = std::atan2(sine, end.z());
    // A half turn passes through the normal.
    const Eigen::Vector3d side =
        sine > 0 ? Eigen::Vector3d(end.x() / sine, end.y() / sine, 0) : Eigen::Vector3d::UnitY();
    turned.col(static_cast<Eigen::Index>(k)) =
        S.frames[k] * (std::cos(t * angle) * Eigen::Vector3d::UnitZ() + std::sin(t * angle) * side);
  }
  return turned;
}

}  // namespace Conformal_geometry_processing
