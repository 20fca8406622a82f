// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <string>

namespace conformal {

/// `output` with the number of a step before its extension: `bear_0005.ply`
/// \pre `output` has an extension
std::string snapshot_path(const std::string& output, int step);

}  // namespace conformal
