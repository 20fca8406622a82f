// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_PERIOD_LIMIT_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_PERIOD_LIMIT_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/spin/Period_limit.h>

#include <algorithm>

namespace Conformal_geometry_processing {

CGP_INLINE double internal::Period_limit::operator()(const Spin_report& report, double share) const
{
  if (maximum) return *maximum * share;
  const double share_of_distortion = 0.25, rounding = 1e-10, least = 0.002, greatest = 0.02;
  const double distortion = report.conformality.quasi_conformal.mean - 1;
  const double closed =
      (std::max)({share_of_distortion * distortion, tolerance, rounding, least * share});
  return (std::min)(closed, greatest * share);
}

}  // namespace Conformal_geometry_processing

#endif
