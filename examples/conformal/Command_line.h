// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/commands/Command.h"

#include <optional>
#include <string>

namespace conformal {

/// The parsed command line
struct Command_line {
  Common_options common;
  std::optional<Command> command;
  Report options;      ///< those in force
  std::string answer;  ///< of `--help` and `--version`; then there is no command
};

/// \throws Failure (usage)
Command_line parse_command_line(int argc, const char* const* argv);

}  // namespace conformal
