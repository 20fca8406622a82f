# Copyright (c) 2026 The Conformal Geometry Processing authors
# SPDX-License-Identifier: LGPL-3.0-or-later
# The subcommands: NAME.cpp defines NAME_command(), for each NAME of this list.

set(CGP_ALL_COMMANDS info spin deform fair flow boundary fit blend flatten curve harmonic spectrum
    sphere compare split studio CACHE INTERNAL "in the order in which they are listed")

# Writes the table of the commands that a program has: cgp_write_commands(<source> <name>...)
function(cgp_write_commands source)
  set(declarations "")
  set(calls "")
  set(others "")
  foreach(command IN LISTS CGP_ALL_COMMANDS)
    if(command IN_LIST ARGN)
      string(APPEND declarations "Command ${command}_command();\n")
      string(APPEND calls "${command}_command(), ")
    else()
      string(APPEND others "\"${command}\", ")
    endif()
  endforeach()
  file(CONFIGURE OUTPUT ${source} @ONLY CONTENT [[
#include "conformal/commands/commands.h"

namespace conformal {

@declarations@
std::vector<Command> commands() { return {@calls@}; }
std::vector<std::string> commands_not_built() { return {@others@}; }

}  // namespace conformal
]])
endfunction()

set(built_commands ${CGP_COMMANDS})
if(CGP_COMMANDS STREQUAL "all")
  set(built_commands ${CGP_ALL_COMMANDS})
endif()
cgp_write_commands(${CMAKE_CURRENT_BINARY_DIR}/commands.cpp ${built_commands})
