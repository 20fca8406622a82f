// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_STOPWATCH_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_STOPWATCH_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Stopwatch.h>

#include <chrono>

namespace Conformal_geometry_processing {

CGP_INLINE double internal::Stopwatch::lap()
{
  const auto now = Clock::now();
  const std::chrono::duration<double> seconds = now - m_start;
  m_start = now;
  return seconds.count();
}

}  // namespace Conformal_geometry_processing

#endif
