// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SURFACES_STEREOGRAPHIC_PROJECTION_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_SURFACES_STEREOGRAPHIC_PROJECTION_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/surfaces/stereographic_projection.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

CGP_INLINE Eigen::Vector3d stereographic_projection(const Quaternion<double>& q)
{
  return imaginary_part(q) / (1 - q.w);
}

CGP_INLINE Quaternion<double> inverse_stereographic_projection(const Eigen::Vector3d& p)
{
  const double s = p.squaredNorm();
  Quaternion<double> q = imaginary(2 * p);
  q.w = s - 1;
  return q / (s + 1);
}

}  // namespace Conformal_geometry_processing

#endif
