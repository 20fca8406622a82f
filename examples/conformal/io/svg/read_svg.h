// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/data/Plane_curve.h"

#include <string>
#include <string_view>
#include <vector>

namespace conformal {

/// Reads the curves of an SVG file, y up: `path` (see `parse_svg_path()`), `polygon` and
/// `polyline`, except those inside definitions (`defs`, `clipPath`, `mask`, ...). Transformations
/// are applied; other shapes are omitted with a note. \throws Read_error
std::vector<Plane_curve> parse_svg(std::string_view bytes, const std::string& path,
                                   const Curve_reading& reading, std::vector<std::string>& notes);

}  // namespace conformal
