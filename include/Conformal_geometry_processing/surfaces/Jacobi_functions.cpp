// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/surfaces/Jacobi_functions.h>

#include <cmath>
#include <cstddef>

namespace Conformal_geometry_processing::internal {

Jacobi_functions::Jacobi_functions(double complement) : m_complement(complement)
{
  double a = 1, g = complement, c = std::sqrt((1 - g) * (1 + g)), power = 0.5, sum = 0;
  for (;;) {
    m_a.push_back(a);
    m_c.push_back(c);
    sum += power * c * c;
    if (c <= 1e-9 * a) break;  // the next one would be its square
    c = (a - g) / 2;
    const double mean = (a + g) / 2;
    g = std::sqrt(a * g);
    a = mean;
    power *= 2;
  }
  m_quarter_period = 2 * std::atan(1.) / a;
  m_ratio = 1 - sum;
}

// The angles of the descending Landen transformation; the first is am t.
Jacobi_functions::Values Jacobi_functions::operator()(double t) const
{
  const std::size_t last = m_a.size() - 1;
  double angle = std::ldexp(m_a[last] * t, static_cast<int>(last)), zeta = 0;
  for (std::size_t n = last; n > 0; --n) {
    zeta += m_c[n] * std::sin(angle);
    angle = (angle + std::asin(m_c[n] / m_a[n] * std::sin(angle))) / 2;
  }
  return {std::hypot(m_complement * std::sin(angle), std::cos(angle)), m_ratio * t + zeta};
}

}  // namespace Conformal_geometry_processing::internal
