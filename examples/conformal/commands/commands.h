// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Command.h"

#include <string>
#include <vector>

// Defined in the file that commands.cmake writes.
namespace conformal {

/// the subcommands that this program was built with, in the order in which they are listed
std::vector<Command> commands();

/// the names of the other ones
std::vector<std::string> commands_not_built();

/// the command that builds these, too
extern const char* const how_to_build_all;

}  // namespace conformal
