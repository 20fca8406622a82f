// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/commands/Command.h"

/// The command `conformal-mpi spin`: the first process reads the command line and tells the result,
/// the others do their part of the work.
namespace conformal::mpi {

Command spin_command();

/// what the other processes do until the first one calls `dismiss()`
void serve();

void dismiss();

}  // namespace conformal::mpi
