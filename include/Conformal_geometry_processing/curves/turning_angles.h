// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_CURVES_TURNING_ANGLES_H
#define CONFORMAL_GEOMETRY_PROCESSING_CURVES_TURNING_ANGLES_H

#include <Conformal_geometry_processing/curves/Polygon_lengths.h>

#include <Eigen/Core>

#include <cmath>

namespace Conformal_geometry_processing {

/// \ingroup PkgCurves
/// \brief by how much a polygon turns at each vertex: in (-pi, pi], positive to the left. O(m).
///
/// The sum over a closed polygon is its turning number times 2 pi, to rounding. Where an edge goes
/// straight back, the sign is arbitrary; `require_polygon()` refuses that.
/// \param points the vertices, 2 x m, m > 2
/// \param angles receives m numbers, zero at the ends of an open polygon
inline void turning_angles(const Plane_points& points, bool is_closed, Eigen::VectorXd& angles)
{
  const Eigen::Index m = points.cols();
  angles.resize(m);
  Eigen::Vector2d before = points.col(0) - points.col(m - 1);
  for (Eigen::Index i = 0; i < m; ++i) {
    const Eigen::Vector2d after = points.col(i + 1 < m ? i + 1 : 0) - points.col(i);
    const double cross = before.x() * after.y() - before.y() * after.x();
    angles[i] = std::atan2(cross, before.dot(after));
    before = after;
  }
  if (!is_closed) angles[0] = angles[m - 1] = 0;
}

/// \relates turning_angles
inline Eigen::VectorXd turning_angles(const Plane_points& points, bool is_closed)
{
  Eigen::VectorXd angles;
  turning_angles(points, is_closed, angles);
  return angles;
}

}  // namespace Conformal_geometry_processing

#endif
