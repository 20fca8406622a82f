// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "run.h"

#include <sys/resource.h>
#include <unistd.h>

#include <cstdio>

namespace {

bool is_memory_limited()
{
  rlimit limit{};
  return ::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
}

}  // namespace

int main(int argc, char** argv)
{
  const int code = conformal::run(argc, argv);
  // A thread of OpenBLAS that finds no memory for its buffer tries again for ever, and is waited
  // for at the end of the process.
  if (is_memory_limited() && std::fflush(nullptr) == 0) ::_exit(code);
  return code;
}
