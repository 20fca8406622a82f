// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_PROCESS_COMMON_OPTIONS_H
#define CONFORMAL_PROCESS_COMMON_OPTIONS_H

#include <string>

namespace conformal {

/// what every command takes
struct Common_options {
  std::string output, json, html;
  int threads = 1;
  unsigned seed = 0;
  double tolerance = 1e-8;
  double max_memory = 0;  ///< in GiB; 0 for half of the machine's
  bool quiet = false, strict = false, repair = false;
  bool each_component = false;  ///< works on one component after the other
  bool keep_going = false;      ///< writes those that succeed
};

}  // namespace conformal

#endif
