// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/curves/turning_angles.h>

#include <Eigen/Core>

#include <cmath>

namespace Conformal_geometry_processing {

void turning_angles(const internal::Plane_points& points, bool is_closed, Eigen::VectorXd& angles)
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

Eigen::VectorXd turning_angles(const internal::Plane_points& points, bool is_closed)
{
  Eigen::VectorXd angles;
  turning_angles(points, is_closed, angles);
  return angles;
}

}  // namespace Conformal_geometry_processing
