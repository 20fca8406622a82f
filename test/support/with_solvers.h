// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/spin/Spin_transformation.h>

namespace cgp_test {

/// options of a transformation, with solvers of some traits
template <class SolverTraits>
Conformal_geometry_processing::Spin_transformation_options with_solvers(
    Conformal_geometry_processing::Spin_transformation_options options = {})
{
  options.solvers = SolverTraits();
  return options;
}

}  // namespace cgp_test
