// Tests include/Conformal_geometry_processing/threads/Signal.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/threads/Signal.h>

#include <gtest/gtest.h>

#include <chrono>

namespace cgp_test::signal_tests {

namespace CGP = Conformal_geometry_processing;

// Both while the other thread polls, and after it has gone to sleep.
TEST(Signal, wakes_a_thread_that_polls_or_sleeps)
{
  for (const int delay : {0, 50}) {
    CGP::internal::Signal signal;
    std::mutex mutex;
    bool is_waiting = false, is_ready = false;
    std::thread waiting([&] {
      std::unique_lock<std::mutex> lock(mutex);
      is_waiting = true;
      while (!is_ready) signal.wait(lock);
      EXPECT_TRUE(lock.owns_lock());
    });
    std::unique_lock<std::mutex> lock(mutex);
    while (!is_waiting) {
      lock.unlock();
      std::this_thread::yield();
      lock.lock();
    }
    lock.unlock();
    std::this_thread::sleep_for(std::chrono::milliseconds(delay));
    lock.lock();
    is_ready = true;
    signal.announce();
    lock.unlock();
    waiting.join();
  }
}

}  // namespace cgp_test::signal_tests
