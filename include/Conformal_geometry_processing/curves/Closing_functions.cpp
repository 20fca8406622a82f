// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/curves/Closing_functions.h>

#include <Eigen/Core>

#include <cmath>

namespace Conformal_geometry_processing {

internal::Closing_functions::Closing_functions(const internal::Plane_points& points,
                                               const Eigen::VectorXd& weights)
{
  const double total = weights.sum();
  m_mean = points * weights / total;
  double xx = 0, xy = 0, yy = 0;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Vector2d p = points.col(i) - m_mean;
    xx += weights[i] * p.x() * p.x();
    xy += weights[i] * p.x() * p.y();
    yy += weights[i] * p.y() * p.y();
  }
  const double angle = std::atan2(2 * xy, xx - yy) / 2;
  m_axis = {std::cos(angle), std::sin(angle)};
  // Not from these sums, which lose all digits for the short axis of a thin curve.
  m_norms = Eigen::Vector3d::Zero();
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    m_norms += weights[i] * values(points.col(i)).cwiseAbs2();
}

Eigen::Vector3d internal::Closing_functions::values(const Eigen::Vector2d& point) const
{
  const Eigen::Vector2d p = point - m_mean;
  return {1, m_axis.x() * p.x() + m_axis.y() * p.y(), m_axis.x() * p.y() - m_axis.y() * p.x()};
}

Eigen::Vector3d internal::Closing_functions::combination(const Eigen::Vector3d& products) const
{
  Eigen::Vector3d c;
  for (int k = 0; k < 3; ++k) c[k] = m_norms[k] > 0 ? products[k] / m_norms[k] : 0;
  return c;
}

}  // namespace Conformal_geometry_processing
