// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <malloc.h>

#include <fstream>
#include <string>

namespace cgp_benchmark {

/// a line of /proc/self/status, in bytes: "VmRSS:" is the memory in use, "VmHWM:" its peak,
/// "RssAnon:" and "RssFile:" are its parts
inline double bytes_of(const std::string& line)
{
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (word == line) {
      double kilobytes = 0;
      status >> kilobytes;
      return 1024 * kilobytes;
    }
  return 0;
}

/// Returns the peak of memory while `stage()` runs, above the initial use: without the code of the
/// program, which is read from its files when it is used first
template <class Stage>
double peak_bytes(Stage stage)
{
  malloc_trim(0);                               // gives back what earlier stages have freed
  std::ofstream("/proc/self/clear_refs") << 5;  // the peak begins anew
  const double before = bytes_of("RssAnon:");
  stage();
  return bytes_of("VmHWM:") - bytes_of("RssFile:") - before;
}

}  // namespace cgp_benchmark
