// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Closed_curve.h"
#include "Surface_input.h"

#include <string>
#include <vector>

namespace conformal {

/// \brief Reads closed curves: text with a point per line, of two or three coordinates, and an
/// empty line between curves; `#` begins a comment. A last point that repeats the first one is left
/// out. \throws Read_error
std::vector<Closed_curve> read_curves(const std::string& path);

/// \brief The directions of curves, one for each boundary loop, at the boundary vertices: at the
/// points of a curve with as many points as its loop has vertices, else at equal shares of the
/// lengths. 3 x number of boundary vertices, not normalised.
/// \throws Failure if the curves do not fit the loops, or one has no direction somewhere;
/// Read_error
CGP::Points tangents_of_curves(const Surface_input& input, const std::string& path);

}  // namespace conformal
