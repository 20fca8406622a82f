// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "support/weierstrass.h"

namespace cgp_test {

Polynomial product(const Polynomial& a, const Polynomial& b)
{
  Polynomial c(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) c[i + j] += a[i] * b[j];
  return c;
}

std::complex<double> value(const Polynomial& a, std::complex<double> z)
{
  std::complex<double> sum = 0;
  for (std::size_t i = a.size(); i-- > 0;) sum = sum * z + a[i];
  return sum;
}

Polynomial integral(const Polynomial& a)
{
  Polynomial b(a.size() + 1);
  for (std::size_t i = 0; i < a.size(); ++i) b[i + 1] = a[i] / static_cast<double>(i + 1);
  return b;
}

}  // namespace cgp_test
