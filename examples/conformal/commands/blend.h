// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_COMMANDS_BLEND_H
#define CONFORMAL_COMMANDS_BLEND_H

#include "Options.h"

#include "conformal/report/Session.h"

namespace conformal {

/// Adds a multiple of the difference between two conformally equivalent surfaces to one of them, or
/// to a third: `conformal blend`.
/// \throws Failure, Read_error, Write_error, and exceptions of the library
void blend(const Blend_options& options, Session& session);

}  // namespace conformal

#endif
