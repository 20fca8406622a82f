// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_CURVES_COMPENSATED_SUM_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_CURVES_COMPENSATED_SUM_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/curves/Compensated_sum.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

CGP_INLINE void internal::Compensated_sum::add(const Eigen::Vector2d& x)
{
  const Eigen::Vector2d sum = m_sum + x;
  const Eigen::Vector2d added = sum - m_sum;
  m_lost += (m_sum - (sum - added)) + (x - added);
  m_sum = sum;
}

}  // namespace Conformal_geometry_processing

#endif
