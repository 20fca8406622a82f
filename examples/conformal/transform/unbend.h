// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/input/Surface_input.h"

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

namespace conformal {

/// a surface that has come near to a plane
struct Unbent_surface {
  CGP::Spin_result result;  ///< the surface, with the report of the last step
  double height = 1;        ///< by its diameter
  int steps = 0;            ///< that were taken
  bool is_flat() const;     ///< as far as is wanted
};

/// \brief Takes the mean curvature of a disk away, with the tangents of its boundary turned to
/// those of a plane curve, see `planar_directions()`.
///
/// There is a plane image [Riemann], and each step goes to it from where the last one led: all of
/// the way, or the largest power of two of it with which edges close up and no face is flipped.
/// \param closure the largest closure residual of a step
Unbent_surface unbend(const CGP::Mesh_view& mesh, double closure);

}  // namespace conformal
