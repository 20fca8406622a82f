// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <limits>
#include <string>

namespace conformal {

/// what stays as it is at the boundary of a surface that has one
enum class Boundary_choice { free, tangents, binormals };

/// The prescribed boundary: exactly one source is not empty
struct Prescription_options {
  std::string tangents_from, binormals_from, positions_from;         ///< files with meshes
  std::string curves_expression, curves_property;                    ///< positive inside on curves
  std::string curve;                                                 ///< a file with points
  std::string tangent_rotation, binormal_tilt;                       ///< formulas
  double position_weight = std::numeric_limits<double>::infinity();  ///< against conformality
};

}  // namespace conformal
