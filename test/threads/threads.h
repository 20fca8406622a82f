// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef TEST_THREADS_THREADS_H
#define TEST_THREADS_THREADS_H

#include <Conformal_geometry_processing/threads/number_of_threads.h>

namespace cgp_test {

/// a number of threads for as long as it lives; afterwards one
struct Threads {
  explicit Threads(int threads) { Conformal_geometry_processing::set_number_of_threads(threads); }
  ~Threads() { Conformal_geometry_processing::set_number_of_threads(1); }
  Threads(const Threads&) = delete;
  Threads& operator=(const Threads&) = delete;
};

}  // namespace cgp_test

#endif
