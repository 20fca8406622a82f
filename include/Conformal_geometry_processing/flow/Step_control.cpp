// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Step_control.h>

#include <algorithm>
#include <utility>

namespace Conformal_geometry_processing::internal {

Time_step::Time_step(double largest, double smallest, double first, double growth)
    : m_largest(largest), m_smallest(smallest), m_value(first), m_growth(growth)
{}

bool Time_step::halve()
{
  if (m_value / 2 < m_smallest) return false;
  m_value /= 2;
  if (std::exchange(m_has_grown, false)) m_next_waiting *= 2;
  m_waiting = m_next_waiting / 2;
  return true;
}

void Time_step::grow()
{
  if (m_waiting > 0) {
    --m_waiting;
    return;
  }
  if (m_has_grown) m_next_waiting = 1;
  m_has_grown = m_value < m_largest;
  m_value = (std::min)(m_growth * m_value, m_largest);
}

}  // namespace Conformal_geometry_processing::internal
