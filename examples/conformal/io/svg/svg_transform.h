// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "svg_path.h"

#include <Eigen/Geometry>

#include <string_view>

namespace conformal {

/// Parses the map of the plane `transform="..."`, in SVG's coordinates: `matrix`, `translate`,
/// `scale`, `rotate`, `skewX` and `skewY`, the last one first. An empty text is the identity.
Eigen::Affine2d parse_svg_transform(std::string_view text, const Svg_fault& fault);

}  // namespace conformal
