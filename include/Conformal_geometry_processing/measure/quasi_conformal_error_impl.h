// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MEASURE_QUASI_CONFORMAL_ERROR_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_MEASURE_QUASI_CONFORMAL_ERROR_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/measure/quasi_conformal_error.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cmath>

namespace Conformal_geometry_processing {
namespace internal {

CGP_INLINE Flat_triangle flattened(const Points& positions, const std::array<int, 3>& corners)
{
  const Eigen::Vector3d u = positions.col(corners[1]) - positions.col(corners[0]);
  const Eigen::Vector3d v = positions.col(corners[2]) - positions.col(corners[0]);
  const double length = u.norm();
  return {length, u.dot(v) / length, u.cross(v).norm() / length};
}

}  // namespace internal

CGP_INLINE Eigen::VectorXd quasi_conformal_errors(const Mesh_view& mesh, const Points& positions)
{
  Eigen::VectorXd Q(mesh.size_of_faces());
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const auto s = internal::flattened(mesh.positions(), mesh.corners(f));
    const auto t = internal::flattened(positions, mesh.corners(f));
    // The map is the upper triangular matrix (a b; 0 d).
    const double a = t.length / s.length, b = (t.x - a * s.x) / s.y, d = t.y / s.y;
    const double largest = (std::hypot(a + d, b) + std::hypot(a - d, b)) / 2;
    Q[f] = largest / (a * d / largest);  // the smaller one from the determinant: no cancellation
    if (std::isnan(Q[f])) Q[f] = HUGE_VAL;
  }
  return Q;
}

CGP_INLINE internal::Distribution quasi_conformal_error(const Mesh_view& mesh,
                                                        const Points& positions)
{
  return distribution(quasi_conformal_errors(mesh, positions), face_areas(mesh));
}

}  // namespace Conformal_geometry_processing

#endif
