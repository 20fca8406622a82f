// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/threads/number_of_threads.h>

#include <algorithm>
#include <atomic>
#include <thread>

namespace Conformal_geometry_processing {
namespace internal {

std::atomic<int>& thread_setting()
{
  static std::atomic<int> threads{1};
  return threads;
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
