// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/parameterization/spectral_parameterization.h>

#include <string>

namespace conformal {

namespace CGP = Conformal_geometry_processing;

/// Calls the library's `spectral_parameterization`. This is the one place that compiles it.
CGP::internal::Parameterization_result solve_flat(const CGP::Mesh_view& mesh,
                                                  const CGP::Parameterization_options& options,
                                                  const std::string& function);

}  // namespace conformal
