// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_FLOW_TIME_STEP_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_FLOW_TIME_STEP_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/flow/Time_step.h>

#include <algorithm>
#include <utility>

namespace Conformal_geometry_processing {

CGP_INLINE internal::Time_step::Time_step(double largest, double smallest, double first)
    : m_largest(largest), m_smallest(smallest), m_value(first)
{}

CGP_INLINE bool internal::Time_step::halve()
{
  if (m_value / 2 < m_smallest) return false;
  m_value /= 2;
  if (std::exchange(m_has_grown, false)) m_next_waiting *= 2;
  m_waiting = m_next_waiting / 2;
  return true;
}

CGP_INLINE void internal::Time_step::grow()
{
  if (m_waiting > 0) {
    --m_waiting;
    return;
  }
  if (m_has_grown) m_next_waiting = 1;
  m_has_grown = m_value < m_largest;
  m_value = (std::min)(1.5 * m_value, m_largest);
}

}  // namespace Conformal_geometry_processing

#endif
