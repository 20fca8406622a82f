// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_COMMANDS_COMMANDS_H
#define CONFORMAL_COMMANDS_COMMANDS_H

#include "Command.h"

#include <vector>

namespace conformal {

// One function for each row of the table, each in the file of its name.
Command info_command();
Command spin_command();
Command deform_command();
Command fair_command();
Command flow_command();
Command boundary_command();
Command fit_command();
Command blend_command();
Command flatten_command();
Command curve_command();
Command harmonic_command();
Command spectrum_command();
Command sphere_command();
Command compare_command();
Command split_command();
Command studio_command();

/// all subcommands, in the order in which they are listed
std::vector<Command> commands();

}  // namespace conformal

#endif
