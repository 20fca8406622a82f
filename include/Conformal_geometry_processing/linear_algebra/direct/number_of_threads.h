// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_NUMBER_OF_THREADS_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_NUMBER_OF_THREADS_H

#include <algorithm>
#include <atomic>
#include <thread>

namespace Conformal_geometry_processing {

namespace internal {

inline std::atomic<int>& thread_setting()
{
  static std::atomic<int> threads{1};
  return threads;
}

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief how many threads a call of this library may use; 1 if nobody has asked for more.
inline int number_of_threads()
{
  return internal::thread_setting();
}

/// \ingroup PkgLinearAlgebra
/// \brief lets every later call of this library, in the whole process, use up to `threads` threads;
/// 0 or less stands for as many as the machine has.
///
/// Threads live no longer than the call, and calls too small to gain from them use none. Results
/// are the same to the bit for any number of threads. May be called from any thread.
inline void set_number_of_threads(int threads)
{
  const int all = (std::max)(1, static_cast<int>(std::thread::hardware_concurrency()));
  internal::thread_setting() = threads > 0 ? threads : all;
}

}  // namespace Conformal_geometry_processing

#endif
