// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_COMMAND_LINE_H
#define CONFORMAL_COMMAND_LINE_H

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

#endif
