// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_COMMANDS_FLATTEN_H
#define CONFORMAL_COMMANDS_FLATTEN_H

#include "Options.h"

#include "conformal/report/Session.h"

namespace conformal {

/// Maps a surface with boundary to the plane: `conformal flatten`.
/// \throws Failure, Read_error, Write_error
void flatten(const Flatten_options& options, Session& session);

}  // namespace conformal

#endif
