// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/spin/solve_dirac_equation.h>

namespace cgp_test {

/// the solution of an equation whose system lives as long as it takes
inline Conformal_geometry_processing::internal::Dirac_solution solved(
    const Conformal_geometry_processing::Surface_ref& surface,
    const Conformal_geometry_processing::Curvature_potential& rho,
    const Conformal_geometry_processing::Dirac_options& options = {},
    const Conformal_geometry_processing::Boundary_condition& condition = {})
{
  Conformal_geometry_processing::internal::Dirac_system system(surface, condition);
  return solve_dirac_equation(system, rho, options);
}

}  // namespace cgp_test
