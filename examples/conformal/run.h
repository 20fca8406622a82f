// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/report/Outcome.h"

#include <string>

namespace conformal {

/// The whole program: executes the command line, prints one line on stderr on failure, and returns
/// the exit code (`Exit_code`).
int run(int argc, const char* const* argv);

/// the exit code and the message of the exception at hand
/// \param input named in errors of the library, if it is not empty
Ending ending_of_exception(const std::string& input);

/// how work ends: with that of what it throws
/// \param input is that which the work has set, see `ending_of_exception()`
template <class Work>
Ending carry_out(const Work& work, const std::string& input = "")
{
  try {
    work();
    return {};
  } catch (...) {
    return ending_of_exception(input);
  }
}

}  // namespace conformal
