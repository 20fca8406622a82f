// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <chrono>

namespace Conformal_geometry_processing::internal {

/// Measures wall-clock time
class Stopwatch {
 public:
  /// Returns the seconds since the construction or the last lap
  double lap();

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point m_start = Clock::now();
};

}  // namespace Conformal_geometry_processing::internal
