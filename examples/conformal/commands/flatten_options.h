// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_COMMANDS_FLATTEN_OPTIONS_H
#define CONFORMAL_COMMANDS_FLATTEN_OPTIONS_H

#include "Options.h"

#include <CLI/CLI.hpp>

namespace conformal {

/// Adds the options that are specific to `conformal flatten`
void add_flatten_options(CLI::App& command, Flatten_options& options);

}  // namespace conformal

#endif
