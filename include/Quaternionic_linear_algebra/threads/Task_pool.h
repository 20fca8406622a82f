// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/threads/Thread_team.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \brief Runs tasks, which may spawn further tasks, on several threads.
///
/// Tasks are numbers. A task may also distribute a loop: idle threads help, so that the last and
/// largest tasks of a tree keep all threads busy as well. The assignment of work to threads is not
/// deterministic; results must not depend on it.
class Task_pool {
 public:
  /// \param threads number of threads, including the caller of `run()`
  explicit Task_pool(int threads) : m_threads((std::max)(1, threads)) {}

  Task_pool(const Task_pool&) = delete;
  Task_pool& operator=(const Task_pool&) = delete;

  /// \brief Calls `action(task)` for the given tasks, in their order, and for those pushed
  /// meanwhile; returns when all are done.
  /// \throw the first exception of an action; tasks that have not begun by then are skipped
  void run(std::vector<int> tasks, const std::function<void(int)>& action);

  /// Adds a task, which precedes those that wait; to be called by an action
  void push(int task);

  /// \brief Calls `visit(i)` for 0 <= i < count, on this thread and idle ones; to be called by an
  /// action.
  /// \throw the exceptions of `visit`
  template <class Visitor>
  void for_each(int count, const Visitor& visit)
  {
    if (m_threads == 1 || count < 2) {
      for (int i = 0; i < count; ++i) visit(i);
      return;
    }
    const std::function<void(int)> reference = std::cref(visit);
    Loop loop(count, reference);
    {
      const std::lock_guard<std::mutex> lock(m_mutex);
      m_loops.push_back(&loop);
      m_events.announce();
    }
    work_on(loop);
    {
      const std::lock_guard<std::mutex> lock(m_mutex);
      m_loops.erase(std::find(m_loops.begin(), m_loops.end(), &loop));
    }
    while (loop.helpers > 0) std::this_thread::yield();
    if (m_has_failed) throw Abandoned();
  }

 private:
  struct Abandoned {};  ///< ends a task after another one, or a helper, has failed

  struct Loop {
    Loop(int count_, const std::function<void(int)>& visit_) : count(count_), visit(visit_) {}
    const int count;
    const std::function<void(int)>& visit;
    std::atomic<int> next{0}, helpers{0};
  };

  void work();
  void begin_task(std::unique_lock<std::mutex>& lock);
  Loop* find_loop() const;
  void help(Loop& loop, std::unique_lock<std::mutex>& lock);
  void work_on(Loop& loop);

  template <class Action>
  void attempt(const Action& action)
  {
    try {
      action();
    } catch (const Abandoned&) {
    } catch (...) {
      const std::lock_guard<std::mutex> lock(m_mutex);
      if (!m_failure) m_failure = std::current_exception();
      m_has_failed = true;
    }
  }

  const int m_threads;
  const std::function<void(int)>* m_action = nullptr;
  std::mutex m_mutex;
  Signal m_events;           // that may concern waiting threads
  std::vector<int> m_tasks;  // waiting; the next one is last
  std::vector<Loop*> m_loops;
  int m_running = 0;
  std::exception_ptr m_failure;
  std::atomic<bool> m_has_failed{false};
};

}  // namespace Conformal_geometry_processing::internal
