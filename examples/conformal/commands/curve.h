// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_COMMANDS_CURVE_H
#define CONFORMAL_COMMANDS_CURVE_H

#include "conformal/curves/Curve_options.h"
#include "conformal/report/Session.h"

namespace conformal {

/// Smooths curves in the plane without stretching them: `conformal curve`. On a signal, the curves
/// after the last complete step are written, and the failure is thrown.
/// \throws Failure if the input is unsuitable, no step can be made, the result does not verify, or
/// a signal was received, and exceptions of the readers and writers
void curve(const Curve_options& options, Session& session);

}  // namespace conformal

#endif
