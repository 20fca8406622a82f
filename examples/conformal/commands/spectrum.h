// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_COMMANDS_SPECTRUM_H
#define CONFORMAL_COMMANDS_SPECTRUM_H

#include "Spectrum_options.h"

#include "conformal/report/Session.h"

namespace conformal {

/// Computes eigenvalues of the Dirac operator: `conformal spectrum`.
/// \throws Failure if the input is unsuitable, not all of them are found, or a signal was received,
/// and exceptions of the readers, the library and the writers
void spectrum(const Spectrum_options& options, Session& session);

}  // namespace conformal

#endif
