// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/threads/Thread_team.h>
#include <Conformal_geometry_processing/threads/number_of_threads.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgThreads
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

/// \ingroup PkgThreads
/// \brief Calls `visit(i)` for 0 <= i < count, on several threads; see `for_each_range()`.
template <class Visitor>
void for_each_index(int count, int least, const Visitor& visit)
{
  for_each_range(count, least, [&](std::ptrdiff_t first, std::ptrdiff_t last) {
    for (int i = static_cast<int>(first); i < static_cast<int>(last); ++i) visit(i);
  });
}

/// \ingroup PkgThreads
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

}  // namespace Conformal_geometry_processing::internal
