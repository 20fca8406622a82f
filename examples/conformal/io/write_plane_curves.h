// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/data/Plane_curve.h"

#include <string>
#include <vector>

namespace conformal {

/// the curves of one moment
using Curve_picture = std::vector<Plane_curve>;

/// Writes curves as SVG, CSV or OBJ, by the extension; the coordinates read back as the same
/// numbers. In CSV and OBJ a closed curve ends with its first point. \throws Write_error
void write_plane_curves(const std::string& path, const std::vector<Plane_curve>& curves);

/// \brief Writes an SVG file that shows the frames one after another in so many seconds, again and
/// again (SMIL, as browsers play it); programs that do not play it show the last one.
/// \param frames at least one; all have the same curves, with as many points
void write_animation(const std::string& path, const std::vector<Curve_picture>& frames,
                     double seconds);

/// \throws Write_error for a path whose extension is not among those that are written
void require_curve_format(const std::string& path);

}  // namespace conformal
