// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_KRYLOV_REFACTORIZATION_RULE_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_KRYLOV_REFACTORIZATION_RULE_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/Refactorization_rule.h>

#include <algorithm>

namespace Conformal_geometry_processing {

CGP_INLINE double factorization_price(const Solver_statistics& s, int components)
{
  return 3 + 0.008 * s.flops / (static_cast<double>(s.factor_entries) * components);
}

CGP_INLINE bool internal::Refactorization_rule::begin_step()
{
  const double last = extra();
  const bool is_worn = m_age > 0 && last * (m_age + 1) > m_price + m_earlier + last;
  if (m_age == 0)
    m_fresh = m_solves;
  else
    m_pause = 1;
  m_earlier += last;
  m_solves = 0;
  ++m_age;
  if (m_pauses_left == 0) return is_worn;
  --m_pauses_left;
  return true;
}

CGP_INLINE void internal::Refactorization_rule::renewed()
{
  m_age = 0;
  m_earlier = m_solves = 0;
}

CGP_INLINE void internal::Refactorization_rule::renewed_in_the_midst()
{
  renewed();
  m_pauses_left = m_pause;
  m_pause = (std::min)(2 * m_pause, 64);
}

}  // namespace Conformal_geometry_processing

#endif
