// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Boundary_options.h"
#include "Surface_input.h"

#include <Conformal_geometry_processing/spin/Boundary_condition.h>

namespace conformal {

/// The corresponding condition of the library
CGP::Boundary_condition kept_boundary(Boundary_choice choice);

/// \throws Failure if something is to be kept at the boundary of a surface without one
void require_boundary_to_keep(const Surface_input& input, Boundary_choice choice);

/// \brief the condition that the user prescribes.
/// \pre the surface has a boundary
/// \throws Failure, Read_error
CGP::Boundary_condition prescribed_boundary(const Surface_input& input,
                                            const Prescription_options& options);

/// \brief the condition that the boundary has the tangents or the binormals that it has on another
/// surface with the same faces.
/// \throws Failure if it is folded there
CGP::Boundary_condition directions_of(const Surface_input& input, const CGP::Mesh_view& target,
                                      Boundary_choice choice);

}  // namespace conformal
