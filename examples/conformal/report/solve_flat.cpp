// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "solve_flat.h"

namespace conformal {

CGP::internal::Parameterization_result solve_flat(const CGP::Mesh_view& mesh,
                                                  const CGP::Parameterization_options& options,
                                                  const std::string& function)
{
  return CGP::spectral_parameterization(mesh, options, function);
}

}  // namespace conformal
