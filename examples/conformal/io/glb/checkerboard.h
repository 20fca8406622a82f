// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace conformal {

/// Returns a PNG image of a checkerboard: `squares` x `squares` squares of `size` x `size` pixels,
/// in white and a grey blue, which shows the distortion of a parameterization.
std::string checkerboard_png(std::size_t squares, std::size_t size);

}  // namespace conformal
