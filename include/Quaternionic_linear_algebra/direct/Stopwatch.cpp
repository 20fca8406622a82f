// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/direct/Stopwatch.h>

namespace Conformal_geometry_processing {

double internal::Stopwatch::lap()
{
  const auto now = Clock::now();
  const std::chrono::duration<double> seconds = now - m_start;
  m_start = now;
  return seconds.count();
}

}  // namespace Conformal_geometry_processing
