// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "solve_fit.h"

#include <utility>

namespace conformal {

Fit_solution solve_fit(const CGP::Mesh_view& mesh, const Fit_problem& problem,
                       const Common_options& common,
                       const std::function<bool(const CGP::Eigensolver_progress&)>& go_further)
{
  CGP::Nearest_spin_options own;
  own.direction = problem.direction;
  own.keep_curvature = problem.keep_curvature;
  own.normal_weight = problem.normal_weight;
  own.shear = problem.shear;
  own.distance_tolerance = problem.distance_tolerance;
  own.scales.bound = problem.scale_bound;
  if (problem.mollification > 0) own.mollification = problem.mollification;
  CGP::Nearest_spin_transformation nearest(mesh, problem.target, "fit", own);
  if (problem.scales.size() > 0) nearest.scale_lengths(problem.scales);
  CGP::Dirac_options dirac;
  dirac.tolerance = common.tolerance;
  dirac.random_seed = common.seed;
  CGP::Nearest_spin_result result = nearest.transform(dirac, std::cref(go_further));
  if (problem.blend != 0 && result.report) result = nearest.blend(result, problem.blend);
  return {{std::move(result.positions), std::move(result.lambda), result.report},
          std::move(result.rho),
          result.distance,
          result.source_distance,
          result.normal_distance,
          result.source_normal_distance,
          result.direction,
          nearest.sign_conflicts()};
}

}  // namespace conformal
