// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace conformal {

// Options that a command takes as `--advanced KEY=VALUE` or `--limit NAME=VALUE`, so that its help
// stays short; `--advanced help` lists them. They are options of a group that the command line does
// not reach, and so have checks, defaults and a place in the report like all others.

/// those that are seldom needed
CLI::App& advanced(CLI::App& command);

/// what the result is judged by
CLI::App& limit(CLI::App& command);

/// How something that is not an option of the command is given, as `--limit closure=VALUE` for
/// `max-closure`, which it was once; empty if not at all.
std::string keyed_option(const CLI::App& command, const std::string& name);

}  // namespace conformal
