// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_COMMANDS_SPHERE_H
#define CONFORMAL_COMMANDS_SPHERE_H

#include "Spectrum_options.h"

#include "conformal/report/Session.h"

namespace conformal {

/// Computes a Dirac sphere: `conformal sphere`.
/// \throws Failure if none exists with these numbers, and exceptions of the library and the writers
void sphere(const Sphere_options& options, Session& session);

}  // namespace conformal

#endif
