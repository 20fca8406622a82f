// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_COMMANDS_SPIN_H
#define CONFORMAL_COMMANDS_SPIN_H

#include "Options.h"

#include "conformal/input/Surface_input.h"
#include "conformal/report/Session.h"

#include <string>

namespace conformal {

/// Transforms a surface and writes it with its certificate: `conformal spin`.
/// \throws Failure if the input is unsuitable or the result does not verify, and exceptions of the
/// readers, the library and the writers
void spin(const Spin_options& options, Session& session);

/// What to try where a result of these options does not verify.
std::string easier_spin(const Spin_options& options);

/// \throws Failure if the options do not fit a surface in one component
void require_possible_spin(const Surface_input& input, const Spin_options& options);

}  // namespace conformal

#endif
