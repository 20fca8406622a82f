// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_COMMANDS_CURVE_COMMAND_LINE_H
#define CONFORMAL_COMMANDS_CURVE_COMMAND_LINE_H

#include "conformal/curves/Curve_options.h"

#include <CLI/CLI.hpp>

namespace conformal {

void add_curve_options(CLI::App& command, Curve_options& curve);

}  // namespace conformal

#endif
