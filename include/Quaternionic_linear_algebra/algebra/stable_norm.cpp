// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/algebra/stable_norm.h>

#include <cmath>

namespace Conformal_geometry_processing {

double stable_norm(const Eigen::Vector3d& v)
{
  const double squared = v.squaredNorm(), least = 1e-280, most = 1e280;
  if (least < squared && squared < most) return std::sqrt(squared);
  return std::hypot(v.x(), v.y(), v.z());  // five times as slow
}

Eigen::Vector3d stable_normalized(const Eigen::Vector3d& v)
{
  const double largest = v.cwiseAbs().maxCoeff();
  return largest > 0 ? Eigen::Vector3d((v / largest).normalized()) : v;
}

}  // namespace Conformal_geometry_processing
