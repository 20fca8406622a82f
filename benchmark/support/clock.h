// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <chrono>
#include <ctime>
#include <limits>

namespace cgp_benchmark {

/// Marks missing measurements: any time is less
constexpr double never = std::numeric_limits<double>::infinity();

/// seconds of the processor, of all threads of this program: other programs do not count
inline double cpu_seconds()
{
  std::timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// seconds that a user waits
inline double wall_seconds()
{
  using namespace std::chrono;
  return duration<double>(steady_clock::now().time_since_epoch()).count();
}

/// the seconds of the processor that the action takes
template <class Action>
double seconds_of(Action action)
{
  const double begin = cpu_seconds();
  action();
  return cpu_seconds() - begin;
}

/// lowers `seconds` to the time of the action, if that is less
template <class Action>
void keep_least(double& seconds, Action action)
{
  seconds = std::min(seconds, seconds_of(action));
}

}  // namespace cgp_benchmark
