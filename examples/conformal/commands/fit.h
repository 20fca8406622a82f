// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_COMMANDS_FIT_H
#define CONFORMAL_COMMANDS_FIT_H

#include "Options.h"

#include "conformal/report/Session.h"

namespace conformal {

/// Deforms a surface conformally, as nearly as it can in the way another mesh of the same faces is
/// deformed: `conformal fit`.
/// \throws Failure, Read_error, Write_error, and exceptions of the library
void fit(const Fit_options& options, Session& session);

}  // namespace conformal

#endif
