// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace conformal {

/// \brief The names that may have been meant by a wrong one, the nearest first, five at most.
///
/// These are the names that begin with it, or have it as one of the words between hyphens, and
/// those that one edit of each three letters makes of it: a letter inserted, left out, replaced, or
/// exchanged with the next one. Upper case counts as lower case.
std::vector<std::string> near_names(std::string_view wrong, const std::vector<std::string>& names);

/// `a, b`
std::string listed(const std::vector<std::string>& names);

}  // namespace conformal
