// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_CURVES_CURVE_FRAME_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_CURVES_CURVE_FRAME_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/curves/Curve_frame.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

CGP_INLINE internal::Plane_points internal::Curve_frame::to_frame(
    const internal::Plane_points& points) const
{
  return m_frame.to_frame(in_space(points)).topRows(2);
}

CGP_INLINE void internal::Curve_frame::from_frame(const internal::Plane_points& points,
                                                  internal::Plane_points& result) const
{
  result = (unit() * points).colwise() + m_frame.center().head<2>();
}

CGP_INLINE Points internal::Curve_frame::in_space(const internal::Plane_points& points)
{
  Points p = Points::Zero(3, points.cols());
  p.topRows(2) = points;
  return p;
}

}  // namespace Conformal_geometry_processing

#endif
