// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_COMMANDS_COMPARE_H
#define CONFORMAL_COMMANDS_COMPARE_H

#include "Options.h"

#include "conformal/report/Session.h"

namespace conformal {

/// Measures the map between two meshes with the same faces: `conformal compare`.
/// \throws Failure if they have not, naming the first difference
void compare(const Compare_options& options, Session& session);

}  // namespace conformal

#endif
