// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_COMMANDS_BOUNDARY_H
#define CONFORMAL_COMMANDS_BOUNDARY_H

#include "Options.h"

#include "conformal/report/Session.h"

namespace conformal {

/// Gives the boundary of a surface other directions or positions: `conformal boundary`.
/// \throws Failure, Read_error, Write_error
void boundary(const Boundary_options& options, Session& session);

}  // namespace conformal

#endif
