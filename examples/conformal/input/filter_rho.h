// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Rho_options.h"
#include "Surface_input.h"

#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Conformal_geometry_processing/painting/image_filters.h>

namespace conformal {

/// \throws Failure if the options of the filter contradict each other
void require_possible_filter(const Rho_options& options);

bool is_filtered_on_surface(const Rho_options& options);

/// the picture as it is painted: filtered if that is asked for
CGP::Gray_image filtered(CGP::Gray_image image, const Rho_options& options);

/// \throws Failure if rho is on the faces
CGP::Curvature_potential filtered(const Surface_input& input, const CGP::Curvature_potential& rho,
                                  const Filter_request& filter);

}  // namespace conformal
