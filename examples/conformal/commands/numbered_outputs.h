// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace conformal {

/// Refuses a name of numbered files, see `snapshot_path()`, one of which would replace an input or
/// cannot be written.
/// \param noun what has the number, for the message
/// \throws Failure (usage), Write_error
void require_new_files(const std::string& noun, const std::string& output, int count,
                       const std::vector<std::string>& inputs);

}  // namespace conformal
