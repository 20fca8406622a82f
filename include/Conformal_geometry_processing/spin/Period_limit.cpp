// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Period_limit.h>

#include <algorithm>

namespace Conformal_geometry_processing {

double internal::Period_limit::operator()(const Spin_report& report) const
{
  if (maximum) return *maximum;
  const double share_of_distortion = 0.25, rounding = 1e-10, least = 0.002, greatest = 0.02;
  const double distortion = report.conformality.quasi_conformal.mean - 1;
  const double closed = (std::max)({share_of_distortion * distortion, tolerance, rounding, least});
  return (std::min)(closed, greatest);
}

}  // namespace Conformal_geometry_processing
