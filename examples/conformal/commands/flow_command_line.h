// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_COMMANDS_FLOW_COMMAND_LINE_H
#define CONFORMAL_COMMANDS_FLOW_COMMAND_LINE_H

#include "Options.h"

#include <CLI/CLI.hpp>

namespace conformal {

/// Adds the options that are specific to `conformal flow`
void add_flow_options(CLI::App& command, Flow_options& flow);

}  // namespace conformal

#endif
