// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_SPHERE_H
#define CONFORMAL_SPHERE_H

#include "Session.h"
#include "Spectrum_options.h"

namespace conformal {

/// Makes a Dirac sphere: `conformal sphere`.
/// \throws Failure if there is none with these numbers, and what the library and the writers throw
void sphere(const Sphere_options& options, Session& session);

}  // namespace conformal

#endif
