// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgThreads
/// \brief Wakes threads that wait for a change of what a mutex protects.
///
/// A thread polls before it goes to sleep, because waking it takes longer than most waits.
class Signal {
 public:
  /// \pre the mutex of the waiting threads is locked
  void announce()
  {
    ++m_events;
    m_wake.notify_all();
  }

  /// Unlocks the mutex until the next event, and locks it again
  void wait(std::unique_lock<std::mutex>& lock)
  {
    const std::int64_t seen = m_events;
    lock.unlock();
    for (int i = 0; i < polls && m_events == seen; ++i) std::this_thread::yield();
    lock.lock();
    m_wake.wait(lock, [&] { return m_events != seen; });
  }

 private:
  static constexpr int polls = 200;

  std::condition_variable m_wake;
  std::atomic<std::int64_t> m_events{0};
};

}  // namespace Conformal_geometry_processing::internal
