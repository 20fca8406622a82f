// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Quaternionic_linear_algebra/direct/Stopwatch.h
#include <Quaternionic_linear_algebra/direct/Stopwatch.h>

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace cgp_test::stopwatch_tests {

// A sleep is never shorter than asked for, so lower bounds hold on any machine.
TEST(Stopwatch, measures_each_lap_from_the_last_one)
{
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  Conformal_geometry_processing::internal::Stopwatch watch;
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  const double first = watch.lap();
  const double second = watch.lap();
  const double total = std::chrono::duration<double>(Clock::now() - start).count();
  EXPECT_GE(first, 0.02);
  EXPECT_GE(second, 0);
  EXPECT_LE(first + second, total);
}

}  // namespace cgp_test::stopwatch_tests
