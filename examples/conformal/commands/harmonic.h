// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_COMMANDS_HARMONIC_H
#define CONFORMAL_COMMANDS_HARMONIC_H

#include "Options.h"

#include "conformal/report/Session.h"

namespace conformal {

/// Computes the harmonic fields of a closed surface with handles: `conformal harmonic`.
/// \throws Failure if the input is unsuitable, and exceptions of the readers, the library and the
/// writers
void harmonic(const Harmonic_options& options, Session& session);

}  // namespace conformal

#endif
