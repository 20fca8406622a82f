// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/config.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgThreads
/// \brief Returns the maximal number of threads of a call of this library; the default is 1.
int number_of_threads();

/// \ingroup PkgThreads
/// \brief Sets the maximal number of threads of all later calls of this library in the process; 0
/// or less selects the number of hardware threads, and more than 1024 are 1024.
///
/// The setting is global if the library is compiled as a shared library; if it is linked
/// statically, or used header-only, each shared library of a program has its own setting.
///
/// Threads end with the call, and calls that are too small to benefit use one thread. Results are
/// bitwise the same for any number of threads. May be called from any thread.
void set_number_of_threads(int threads);

namespace internal {

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

/// \brief Calls `visit(first, last)` for ranges that make up 0 <= i < count, on several threads.
///
/// The ranges depend on the number of threads; results must not depend on the ranges.
/// \param least number of elements that are worth a range to threads that wait: some 20
///   microseconds of work; five times as many are where threads have to start
/// \param per_thread number of ranges for each thread; more than one balance uneven work
/// \throw an exception of `visit`
template <class Visitor>
void for_each_range(std::ptrdiff_t count, std::ptrdiff_t least, const Visitor& visit,
                    int per_thread = 4)
{
  const std::ptrdiff_t worth_it = Thread_team::exists() ? least : 5 * least;
  const std::ptrdiff_t most = count / (std::max)(worth_it, std::ptrdiff_t(1));
  const int threads = static_cast<int>((std::min)(most, std::ptrdiff_t(number_of_threads())));
  if (threads <= 1) return visit(std::ptrdiff_t(0), count);
  const std::ptrdiff_t ranges = (std::min)(most, std::ptrdiff_t(threads) * per_thread);
  std::atomic<std::ptrdiff_t> next{0};
  const auto work = [&] {
    for (std::ptrdiff_t i = next++; i < ranges; i = next++)
      visit(static_cast<std::ptrdiff_t>(std::int64_t(count) * i / ranges),
            static_cast<std::ptrdiff_t>(std::int64_t(count) * (i + 1) / ranges));
  };
  Thread_team().run(threads, std::cref(work));
}

/// \brief Calls `visit(i)` for 0 <= i < count, on several threads; see `for_each_range()`.
template <class Visitor>
void for_each_index(int count, int least, const Visitor& visit)
{
  for_each_range(count, least, [&](std::ptrdiff_t first, std::ptrdiff_t last) {
    for (int i = static_cast<int>(first); i < static_cast<int>(last); ++i) visit(i);
  });
}

/// \brief Returns the sum of what `add(first, last, sum)` adds to `zero`, over ranges of `size`
/// elements from the first to the last: the same bits for any number of threads.
/// \param least number of ranges that are worth a thread
template <class Sum, class Add>
Sum sum_of_ranges(std::ptrdiff_t count, std::ptrdiff_t size, const Sum& zero, const Add& add,
                  std::ptrdiff_t least = 1)
{
  const std::ptrdiff_t ranges = (count + size - 1) / size;
  const auto part = [&](std::ptrdiff_t i) {
    Sum sum = zero;
    add(i * size, (std::min)(count, (i + 1) * size), sum);
    return sum;
  };
  Sum all = zero;
  if (number_of_threads() == 1 || ranges < 2 * least) {
    for (std::ptrdiff_t i = 0; i < ranges; ++i) all += part(i);
    return all;
  }
  std::vector<Sum> sums(static_cast<std::size_t>(ranges), zero);
  for_each_range(ranges, least, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
    for (std::ptrdiff_t i = begin; i < end; ++i) sums[static_cast<std::size_t>(i)] = part(i);
  });
  for (const Sum& sum : sums) all += sum;
  return all;
}

}  // namespace internal
}  // namespace Conformal_geometry_processing
