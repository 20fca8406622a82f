// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/data/Plane_curve.h"

#include <string>
#include <vector>

namespace conformal {

/// the formats of files with curves
enum class Curve_format { svg, csv, obj };

/// by the extension of the path, in any case of letters; text (.csv, .txt, .xy) is CSV
std::optional<Curve_format> curve_format_of(const std::string& path);

/// \brief Reads the curves of a file: SVG; text with a point per line, an empty line between
/// curves; or OBJ with lines (`l`).
///
/// A curve is closed if its last point repeats its first one, which is then omitted, or if the
/// format says so; in a text also if its last point is no further from the first than the longest
/// edge. Points that repeat the previous one are omitted, with a note. \throws Read_error
std::vector<Plane_curve> read_plane_curves(const std::string& path, const Curve_reading& reading,
                                           std::vector<std::string>& notes);

}  // namespace conformal
