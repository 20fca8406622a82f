// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "solve_fit.h"

#include <utility>

namespace conformal {

Fit_solution solve_fit(const CGP::Mesh_view& mesh, const Fit_problem& problem,
                       const std::function<bool(const CGP::Eigensolver_progress&)>& go_further)
{
  CGP::Nearest_spin_transformation nearest(mesh, problem.target, "fit", problem.request);
  if (problem.scales.size() > 0) nearest.scale_lengths(problem.scales);
  CGP::Nearest_spin_result result = nearest.transform(std::cref(go_further));
  if (problem.blend != 0 && result.report) result = nearest.blend(result, problem.blend);
  return {{{std::move(result.positions), std::move(result.lambda), result.report}},
          std::move(result.rho),
          result.distance,
          result.source_distance,
          result.normal_distance,
          result.source_normal_distance,
          result.direction,
          nearest.sign_conflicts()};
}

}  // namespace conformal
