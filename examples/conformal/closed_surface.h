// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_CLOSED_SURFACE_H
#define CONFORMAL_CLOSED_SURFACE_H

#include "Session.h"
#include "Surface_input.h"

#include <string>

namespace conformal {

/// Reads a closed surface and enters it into the report.
/// \throws Failure if it is unsuitable, or under --strict had to be repaired; Read_error
Surface_input read_closed_surface(const std::string& path, Session& session);

}  // namespace conformal

#endif
