// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_COMMANDS_INFO_H
#define CONFORMAL_COMMANDS_INFO_H

#include "Options.h"

#include "conformal/input/Surface_input.h"
#include "conformal/report/Session.h"

namespace conformal {

/// Tells about any surface that can be read: `conformal info`.
/// \throws Failure under --strict if the surface cannot be transformed
void info(const Info_options& options, Session& session);

}  // namespace conformal

#endif
