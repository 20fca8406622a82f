// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/data/Plane_curve.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace conformal {

/// what to do with a fault of the text: throw
using Svg_fault = std::function<void(const std::string& message)>;

/// The numbers of `points="..."`, in pairs, in SVG's coordinates: y down.
std::vector<Eigen::Vector2d> parse_svg_points(std::string_view text, const Svg_fault& fault);

/// The parts of a path, `d="..."`, in SVG's coordinates: y down. Lines, cubic and quadratic Bezier
/// segments with so many samples each, and elliptic arcs with so many for each quarter of an
/// ellipse, absolute or relative.
/// A part that ends with Z is closed, as is one that comes back to its first point.
std::vector<Plane_curve> parse_svg_path(std::string_view text, int samples, const Svg_fault& fault);

}  // namespace conformal
