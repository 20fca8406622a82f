// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/threads/Signal.h>

#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgThreads
/// \brief Threads that help this one, and wait for work as long as the team exists.
///
/// Starting a thread takes as long as a hundred thousand operations, waking one a quarter of that,
/// or less. A function that distributes its work many times therefore creates a team; one that is
/// created in the lifetime of another, by the same thread, is the same team. Threads start when
/// they are needed first.
class Thread_team {
 public:
  Thread_team();
  ~Thread_team();

  /// whether this thread has a team, whose threads wait already
  static bool exists();

  Thread_team(const Thread_team&) = delete;
  Thread_team& operator=(const Thread_team&) = delete;

  /// \brief Calls `work()` on this thread and, at the same time, up to once on each of
  /// `threads` - 1 others; returns when all calls have.
  ///
  /// There may be fewer calls, if threads wake up too late, or cannot start: `work` takes what is
  /// left to do until nothing is. Within `work` there is only one call.
  /// \throw an exception of `work`
  void run(int threads, const std::function<void()>& work);

 private:
  void hire(int helpers);
  void help();
  void attempt(const std::function<void()>& work);

  Thread_team* const m_team;  ///< the one that was created first
  std::mutex m_mutex;
  Signal m_begin, m_end;
  std::vector<std::thread> m_helpers;
  const std::function<void()>* m_work = nullptr;
  int m_vacancies = 0;  ///< number of threads that may still begin to work
  int m_working = 0;
  bool m_is_over = false;
  std::exception_ptr m_failure;
};

}  // namespace Conformal_geometry_processing::internal
