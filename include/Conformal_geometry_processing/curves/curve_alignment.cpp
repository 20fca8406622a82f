// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/curves/curve_alignment.h>

#include <Eigen/Core>

#include <cmath>

namespace Conformal_geometry_processing {

double align(const internal::Plane_points& to, const Eigen::VectorXd& weights,
             internal::Plane_points& points)
{
  const double total = weights.sum();
  const Eigen::Vector2d from_mean = points * weights / total, to_mean = to * weights / total;
  double cosine = 0, sine = 0;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Vector2d p = points.col(i) - from_mean, q = to.col(i) - to_mean;
    cosine += weights[i] * p.dot(q);
    sine += weights[i] * (p.x() * q.y() - p.y() * q.x());
  }
  const double angle = std::atan2(sine, cosine);
  const double c = std::cos(angle), s = std::sin(angle);
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Vector2d p = points.col(i) - from_mean;
    points.col(i) = Eigen::Vector2d(c * p.x() - s * p.y(), s * p.x() + c * p.y()) + to_mean;
  }
  return angle;
}

}  // namespace Conformal_geometry_processing
