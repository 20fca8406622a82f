// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/report/Outcome.h"

namespace conformal {

/// The whole program: executes the command line, prints one line on stderr on failure, and returns
/// the exit code (`Exit_code`).
int run(int argc, const char* const* argv);

/// the exit code and the message of the exception at hand
Ending ending_of_exception();

/// how work ends: with that of what it throws
template <class Work>
Ending carry_out(const Work& work)
{
  try {
    work();
    return {};
  } catch (...) {
    return ending_of_exception();
  }
}

}  // namespace conformal
