// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_VERSIONS_H
#define CONFORMAL_VERSIONS_H

#include <string>

namespace conformal {

/// the program's version and those of the libraries it computes with, a line each
std::string versions();

}  // namespace conformal

#endif
