// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Command_line.h"

namespace conformal {

/// \brief Refuses outputs that would destroy a file the command reads or another output, whatever
/// the ways are in which the two are named.
///
/// Only the result may replace the mesh, or the curves, that it is made of.
/// \throws Failure (usage)
void require_separate_outputs(const Command_line& line);

}  // namespace conformal
