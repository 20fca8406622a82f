// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_IO_GLB_CHECKERBOARD_H
#define CONFORMAL_IO_GLB_CHECKERBOARD_H

#include <cstddef>
#include <string>

namespace conformal {

/// Returns a PNG image of a checkerboard: `squares` x `squares` squares of `size` x `size` pixels,
/// in white and a grey blue, which shows the distortion of a parameterization.
std::string checkerboard_png(std::size_t squares, std::size_t size);

}  // namespace conformal

#endif
