// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/data/Plane_curve.h"

#include <string>
#include <string_view>
#include <vector>

namespace conformal {

/// Reads curves from text: a point per line, x and y, an empty line between curves; `#` begins a
/// comment, a first line of words is a heading. \throws Read_error
std::vector<Plane_curve> parse_curve_rows(std::string_view bytes, const std::string& path);

/// Reads the lines (`l`) of an OBJ file whose vertices have z = 0; one without lines is a curve
/// along its vertices. \throws Read_error
std::vector<Plane_curve> parse_obj_lines(std::string_view bytes, const std::string& path);

}  // namespace conformal
