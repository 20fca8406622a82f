// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <string>

namespace conformal {

/// Where progress goes: on a terminal a line that is erased, elsewhere a line every ten seconds;
/// nowhere; or an object of JSON on each line
enum class Progress_choice { automatic, none, json };

/// what every command takes
struct Common_options {
  std::string output, json, html;
  int threads = 1;
  double max_memory = 0;  ///< in GiB; 0 for half of the machine's
  Progress_choice progress = Progress_choice::automatic;
  bool ascii = false, is_single = false;  ///< how PLY is written
  bool quiet = false, strict = false, repair = false;
  bool each_component = false;  ///< works on one component after the other
  bool keep_going = false;      ///< writes those that succeed
};

}  // namespace conformal
