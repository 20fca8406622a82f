// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_RUN_H
#define CONFORMAL_RUN_H

namespace conformal {

/// The whole program: executes the command line, prints one line on stderr on failure, and returns
/// the exit code (`Exit_code`).
int run(int argc, const char* const* argv);

}  // namespace conformal

#endif
