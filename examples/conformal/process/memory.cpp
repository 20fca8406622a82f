// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "memory.h"

#include "machine_memory.h"

#include <sys/resource.h>

#include <array>
#include <cstdio>

namespace conformal {
namespace {

std::array<char, 120> reason = {"out of memory; try: a coarser mesh"};

const double bytes_per_gibibyte = 1 << 30;

// Sanitizers reserve more for themselves than a machine has.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool may_be_limited = false;
#else
constexpr bool may_be_limited = true;
#endif

}  // namespace

void limit_memory(double gibibytes)
{
  const double bytes = gibibytes > 0 ? gibibytes * bytes_per_gibibyte : machine_memory() / 2;
  rlimit limit{};
  if (!may_be_limited || ::getrlimit(RLIMIT_DATA, &limit) != 0) return;
  if (bytes >= static_cast<double>(limit.rlim_cur)) return;  // the system's own limit is lower
  limit.rlim_cur = static_cast<rlim_t>(bytes);
  if (::setrlimit(RLIMIT_DATA, &limit) != 0) return;
  std::snprintf(
      reason.data(), reason.size(),
      "out of memory: more than %.3g GiB; try: a coarser mesh, or a higher --advanced max-memory",
      bytes / bytes_per_gibibyte);
}

const char* why_memory_is_out()
{
  return reason.data();
}

}  // namespace conformal
