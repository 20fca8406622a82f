// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/report/Outcome.h"

#include <functional>

namespace conformal {

/// The whole program: executes the command line, prints one line on stderr on failure, and returns
/// the exit code (`Exit_code`).
int run(int argc, const char* const* argv);

/// how work ends: with the exit code and the message of what it throws
Ending carry_out(const std::function<void()>& work);

}  // namespace conformal
