// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/curves/Compensated_sum.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

void internal::Compensated_sum::add(const Eigen::Vector2d& x)
{
  const Eigen::Vector2d sum = m_sum + x;
  const Eigen::Vector2d added = sum - m_sum;
  m_lost += (m_sum - (sum - added)) + (x - added);
  m_sum = sum;
}

}  // namespace Conformal_geometry_processing
