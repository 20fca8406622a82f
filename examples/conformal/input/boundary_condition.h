// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Surface_input.h"

#include <Conformal_geometry_processing/spin/Boundary_condition.h>

#include <limits>
#include <string>

namespace conformal {

/// The prescribed boundary: exactly one source is not empty
struct Prescription_options {
  std::string tangents_from, binormals_from, positions_from;         ///< files with meshes
  std::string curves_expression, curves_property;                    ///< positive inside on curves
  std::string curve;                                                 ///< a file with points
  std::string tangent_rotation, binormal_tilt;                       ///< formulas
  double position_weight = std::numeric_limits<double>::infinity();  ///< against conformality
};

/// \throws Failure if something is to be kept at the boundary of a surface without one
void require_boundary_to_keep(const Surface_input& input, const CGP::Boundary_condition& kept);

/// \brief the condition that the user prescribes.
/// \pre the surface has a boundary
/// \throws Failure, Read_error
CGP::Boundary_condition prescribed_boundary(const Surface_input& input,
                                            const Prescription_options& options);

/// \brief the condition that the boundary has the directions, of coefficients (t, n, b), that it
/// has on another surface with the same faces. \throws Failure if it is folded there
CGP::Boundary_condition directions_of(const Surface_input& input, const CGP::Mesh_view& target,
                                      const Eigen::Vector3d& direction);

}  // namespace conformal
