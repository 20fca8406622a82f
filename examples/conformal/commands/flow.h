// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_COMMANDS_FLOW_H
#define CONFORMAL_COMMANDS_FLOW_H

#include "Options.h"

#include "conformal/report/Session.h"

namespace conformal {

/// Smooths a closed surface by the conformal Willmore flow: `conformal flow`. On a signal, the
/// surface after the last complete step is written, and the failure is thrown.
/// \throws Failure if the input is unsuitable, no step can be made, the result does not verify, or
/// a signal was received, and exceptions of the readers, the library and the writers
void flow(const Flow_options& options, Session& session);

}  // namespace conformal

#endif
