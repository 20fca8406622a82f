// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/curves/Curve_frame.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

internal::Plane_points internal::Curve_frame::to_frame(const internal::Plane_points& points) const
{
  return m_frame.to_frame(in_space(points)).topRows(2);
}

void internal::Curve_frame::from_frame(const internal::Plane_points& points,
                                       internal::Plane_points& result) const
{
  result = (unit() * points).colwise() + m_frame.center().head<2>();
}

Points internal::Curve_frame::in_space(const internal::Plane_points& points)
{
  Points p = Points::Zero(3, points.cols());
  p.topRows(2) = points;
  return p;
}

}  // namespace Conformal_geometry_processing
