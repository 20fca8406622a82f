// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Plane_polygon.h"

#include <array>
#include <cstddef>
#include <vector>

namespace conformal {

/// \brief Cuts a simple polygon into triangles, of which it returns the corners; of one that
/// crosses itself, it makes some triangles.
///
/// Each cut of a polygon of at most a hundred corners is the one that leaves the best worst
/// triangle. Larger ones are cut all around, every other corner, until they are as small: usually
/// O(n log n).
std::vector<std::array<std::size_t, 3>> ears_of(const Plane_polygon& polygon);

}  // namespace conformal
