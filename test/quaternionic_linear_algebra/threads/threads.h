// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/threads/Thread_team.h>

namespace cgp_test {

/// a number of threads for as long as it lives; afterwards one
struct Threads {
  explicit Threads(int threads) { Conformal_geometry_processing::set_number_of_threads(threads); }
  ~Threads() { Conformal_geometry_processing::set_number_of_threads(1); }
  Threads(const Threads&) = delete;
  Threads& operator=(const Threads&) = delete;
};

}  // namespace cgp_test
