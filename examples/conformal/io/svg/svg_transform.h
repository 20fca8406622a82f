// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_IO_SVG_SVG_TRANSFORM_H
#define CONFORMAL_IO_SVG_SVG_TRANSFORM_H

#include "svg_path.h"

#include <Eigen/Geometry>

#include <string_view>

namespace conformal {

/// Parses the map of the plane `transform="..."`, in SVG's coordinates: `matrix`, `translate`,
/// `scale`, `rotate`, `skewX` and `skewY`, the last one first. An empty text is the identity.
Eigen::Affine2d parse_svg_transform(std::string_view text, const Svg_fault& fault);

}  // namespace conformal

#endif
