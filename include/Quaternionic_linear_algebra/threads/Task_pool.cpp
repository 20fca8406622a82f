// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/threads/Task_pool.h>

#include <utility>

namespace Conformal_geometry_processing {

void internal::Task_pool::run(std::vector<int> tasks, const std::function<void(int)>& action)
{
  m_tasks = std::move(tasks);
  std::reverse(m_tasks.begin(), m_tasks.end());
  m_action = &action;
  m_failure = nullptr;
  m_has_failed = false;
  Thread_team().run(m_threads, [this] { work(); });
  if (m_failure) std::rethrow_exception(m_failure);
}

void internal::Task_pool::push(int task)
{
  const std::lock_guard<std::mutex> lock(m_mutex);
  m_tasks.push_back(task);
  m_events.announce();
}

// All of the following except work_on() require a locked mutex.
void internal::Task_pool::work()
{
  std::unique_lock<std::mutex> lock(m_mutex);
  for (;;) {
    if (!m_tasks.empty())
      begin_task(lock);
    else if (m_running == 0)
      return;
    else if (Loop* const loop = find_loop())
      help(*loop, lock);
    else
      m_events.wait(lock);
  }
}

void internal::Task_pool::begin_task(std::unique_lock<std::mutex>& lock)
{
  const int task = m_tasks.back();
  m_tasks.pop_back();
  ++m_running;
  lock.unlock();
  attempt([&] { (*m_action)(task); });
  lock.lock();
  if (m_has_failed) m_tasks.clear();
  if (--m_running == 0 && m_tasks.empty()) m_events.announce();
}

internal::Task_pool::Loop* internal::Task_pool::find_loop() const
{
  for (Loop* loop : m_loops)
    if (loop->next < loop->count) return loop;
  return nullptr;
}

void internal::Task_pool::help(Loop& loop, std::unique_lock<std::mutex>& lock)
{
  ++loop.helpers;
  lock.unlock();
  work_on(loop);
  --loop.helpers;  // the loop may be destroyed from here on
  lock.lock();
}

void internal::Task_pool::work_on(Loop& loop)
{
  attempt([&] {
    for (int i = loop.next++; i < loop.count && !m_has_failed; i = loop.next++) loop.visit(i);
  });
}

}  // namespace Conformal_geometry_processing
