// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "solve_robustly.h"

#include <Conformal_geometry_processing/flow/Closing_spin_transformation.h>

namespace conformal {

Spin_solution solve_robustly(
    const CGP::Mesh_view& mesh, const Spin_problem& problem, const CGP::Dirac_options& options,
    const std::function<bool(const CGP::Eigensolver_progress&)>& go_further)
{
  CGP::Closing_options closing;
  if (!problem.closes_loops) closing.exactness.reset();
  CGP::Robust_closing_spin_transformation<> transformation(mesh, closing, problem.boundary,
                                                           problem.mollification, "spin");
  CGP::Spin_result result =
      std::move(transformation).transform(problem.rho, options, std::cref(go_further));
  return {std::move(result.positions), std::move(result.lambda), result.report};
}

}  // namespace conformal
