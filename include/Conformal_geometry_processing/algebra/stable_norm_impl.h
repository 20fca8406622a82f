// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_ALGEBRA_STABLE_NORM_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_ALGEBRA_STABLE_NORM_IMPL_H

#include <Conformal_geometry_processing/algebra/stable_norm.h>
#include <Conformal_geometry_processing/config.h>

#include <Eigen/Core>

#include <cmath>

namespace Conformal_geometry_processing {

CGP_INLINE double stable_norm(const Eigen::Vector3d& v)
{
  const double squared = v.squaredNorm(), least = 1e-280, most = 1e280;
  if (least < squared && squared < most) return std::sqrt(squared);
  return std::hypot(v.x(), v.y(), v.z());  // five times as slow
}

CGP_INLINE Eigen::Vector3d stable_normalized(const Eigen::Vector3d& v)
{
  const double largest = v.cwiseAbs().maxCoeff();
  return largest > 0 ? Eigen::Vector3d((v / largest).normalized()) : v;
}

}  // namespace Conformal_geometry_processing

#endif
