// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_COMMANDS_EDITING_OPTIONS_H
#define CONFORMAL_COMMANDS_EDITING_OPTIONS_H

#include "Options.h"

#include <CLI/CLI.hpp>

namespace conformal {

// Options of the commands that transform one surface to another.

void add_fit_options(CLI::App& command, Fit_options& fit);
void add_blend_options(CLI::App& command, Blend_options& blend);

}  // namespace conformal

#endif
