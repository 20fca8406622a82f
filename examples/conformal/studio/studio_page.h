// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Studio_shape.h"
#include "studio_frame.h"

#include <string>
#include <vector>

namespace conformal {

/// \brief Creates a self-contained page on which curvature is painted, and which needs no network.
///
/// It contains the kernels as WebAssembly, and of each shape k the blocks `positions-k` (float64, 3
/// per vertex), `faces-k` (uint32), `squares-k` (float32, 2 per corner) and `origin-k` (uint32,
/// `vertex_in_file`).
std::string studio_page(const std::vector<Studio_shape>& shapes, const Studio_frame& frame);

}  // namespace conformal
