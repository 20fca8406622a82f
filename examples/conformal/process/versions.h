// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_PROCESS_VERSIONS_H
#define CONFORMAL_PROCESS_VERSIONS_H

#include <string>

namespace conformal {

/// Versions of the program and of its numerical libraries, one line each
std::string versions();

}  // namespace conformal

#endif
