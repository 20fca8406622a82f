// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/surfaces/stereographic_projection.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

Eigen::Vector3d stereographic_projection(const Quaternion<double>& q)
{
  return imaginary_part(q) / (1 - q.w);
}

Quaternion<double> inverse_stereographic_projection(const Eigen::Vector3d& p)
{
  const double s = p.squaredNorm();
  Quaternion<double> q = imaginary(2 * p);
  q.w = s - 1;
  return q / (s + 1);
}

}  // namespace Conformal_geometry_processing
