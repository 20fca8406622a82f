// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_SPIN_H
#define CONFORMAL_SPIN_H

#include "Session.h"

namespace conformal {

/// Transforms a surface and writes it with its certificate: `conformal spin`.
/// \throws Failure if the input is unsuitable or the result does not verify, and what the readers,
/// the library and the writers throw
void spin(const Spin_options& options, Session& session);

}  // namespace conformal

#endif
