// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <string>

namespace conformal {

/// Versions of the program and of its numerical libraries, one line each
std::string versions();

}  // namespace conformal
