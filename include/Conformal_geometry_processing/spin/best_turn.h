// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_BEST_TURN_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_BEST_TURN_H

#include <Conformal_geometry_processing/algebra/Quaternion_vector.h>
#include <Conformal_geometry_processing/linear_algebra/quaternionic_jacobi.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

#include <algorithm>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief the one rotation that turns directions U into V as well as a single one can: a unit
/// quaternion q of least sum |U q - q V|^2, and of those that fit about as well (all U may lie on a
/// line, or nearly so) the nearest to 1. \param U, V unit vectors, 3 x n with n > 0
inline Quaternion<double> best_turn(const Points& U, const Points& V)
{
  const Quaternion<double> units[] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
  Eigen::Matrix4d M = Eigen::Matrix4d::Zero();  // of the mean of |U q - q V|^2, in [0, 4]
  for (Eigen::Index k = 0; k < U.cols(); ++k) {
    Eigen::Matrix4d A;
    for (int c = 0; c < 4; ++c) {
      const Quaternion<double> q = imaginary(U.col(k)) * units[c] - units[c] * imaginary(V.col(k));
      A.col(c) << q.w, q.x, q.y, q.z;
    }
    M += A.transpose() * A / static_cast<double>(U.cols());
  }
  // Real numbers are quaternions, and this one is compiled anyway.
  const auto eigen = quaternionic_jacobi<double>(M.unaryExpr([](double m) {
    return Quaternion<double>{m, 0, 0, 0};
  }));
  const auto vector = [&](int c) -> Eigen::Vector4d {
    return eigen.vectors.col(c).unaryExpr([](const Quaternion<double>& q) { return q.w; });
  };
  // Where even the best turn does not fit, others that miss up to three times as much are as good:
  // binormals of a hemisphere, all nearly parallel, that shall tilt inward ask for no half turn.
  const double as_good = std::max(0.02, 2 * eigen.values[0]), nothing = 1e-3;
  Eigen::Vector4d best = Eigen::Vector4d::Zero();
  for (int c = 0; c < 4; ++c)
    if (eigen.values[c] <= eigen.values[0] + as_good) best += vector(c)[0] * vector(c);
  if (best.norm() < nothing) best = vector(0);
  best.normalize();
  return {best[0], best[1], best[2], best[3]};
}

}  // namespace Conformal_geometry_processing

#endif
