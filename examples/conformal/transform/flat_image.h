// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Flatten_options.h"

#include "conformal/input/Surface_input.h"
#include "conformal/report/Session.h"

#include <Conformal_geometry_processing/parameterization/cones.h>

#include <vector>

namespace conformal {

using Seams = std::vector<CGP::internal::Seam>;

/// \brief Maps a surface with boundary, in one component, to the plane, tells the quality, and
/// concludes on it.
/// \param seams where the surface was cut through cones, or none
/// \returns positions, 3 x |V|, in units of the mesh; z is 0
/// \throws Failure if the options do not fit it or the result does not verify, and exceptions of
/// the library
CGP::Points flat_image(const Surface_input& input, const Seams& seams,
                       const Flatten_options& options, Session& session);

}  // namespace conformal
