// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/threads/Thread_team.h>

#include <utility>

namespace Conformal_geometry_processing {
namespace internal {

std::atomic<int>& thread_setting()
{
  static std::atomic<int> threads{1};
  return threads;
}

/// What this thread belongs to
struct Membership {
  Thread_team* team = nullptr;
  bool is_working = false;  ///< within Thread_team::run()
};

Membership& membership()
{
  static thread_local Membership own;
  return own;
}

Thread_team::Thread_team() : m_team(membership().team ? membership().team : this)
{
  membership().team = m_team;
}

bool Thread_team::exists()
{
  return membership().team != nullptr;
}

Thread_team::~Thread_team()
{
  if (m_team != this) return;
  membership().team = nullptr;
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_is_over = true;
    m_begin.announce();
  }
  for (std::thread& t : m_helpers) t.join();
}

void Thread_team::run(int threads, const std::function<void()>& work)
{
  if (threads <= 1 || membership().is_working) return work();
  if (m_team != this) return m_team->run(threads, work);
  hire(threads - 1);
  std::unique_lock<std::mutex> lock(m_mutex);
  m_failure = nullptr;
  m_work = &work;
  m_vacancies = threads - 1;
  m_begin.announce();
  lock.unlock();
  attempt(work);
  lock.lock();
  m_vacancies = 0;
  while (m_working > 0) m_end.wait(lock);
  if (m_failure) std::rethrow_exception(std::exchange(m_failure, nullptr));
}

void Thread_team::hire(int helpers)
{
  try {
    while (m_helpers.size() < static_cast<std::size_t>(helpers))
      m_helpers.emplace_back([this] { help(); });
  } catch (...) {  // continues with fewer threads
  }
}

void Thread_team::help()
{
  membership() = {this, true};
  std::unique_lock<std::mutex> lock(m_mutex);
  while (!m_is_over) {
    if (m_vacancies == 0) {
      m_begin.wait(lock);
      continue;
    }
    --m_vacancies;
    ++m_working;
    const std::function<void()>& work = *m_work;
    lock.unlock();
    attempt(work);
    lock.lock();
    if (--m_working == 0) m_end.announce();
  }
}

void Thread_team::attempt(const std::function<void()>& work)
{
  const bool was_working = std::exchange(membership().is_working, true);
  try {
    work();
  } catch (...) {
    const std::lock_guard<std::mutex> lock(m_mutex);
    if (!m_failure) m_failure = std::current_exception();
  }
  membership().is_working = was_working;
}

}  // namespace internal

int number_of_threads()
{
  return internal::thread_setting();
}

void set_number_of_threads(int threads)
{
  const int all = (std::max)(1, static_cast<int>(std::thread::hardware_concurrency()));
  internal::thread_setting() = (std::min)(threads > 0 ? threads : all, 1024);
}

}  // namespace Conformal_geometry_processing
