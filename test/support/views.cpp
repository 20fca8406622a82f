// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "support/views.h"

namespace cgp_test {

double greatest_distance(const Points& a, const Points& b)
{
  return (a - b).colwise().norm().maxCoeff();
}

}  // namespace cgp_test
