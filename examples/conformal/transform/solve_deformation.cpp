// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "solve_deformation.h"

#include <Conformal_geometry_processing/spin/Conformal_deformation.h>

#include <utility>

namespace conformal {

Deformation_solution solve_deformation(
    const CGP::Mesh_view& mesh, const Deformation_problem& problem,
    const std::function<bool(const CGP::Eigensolver_progress&)>& go_further)
{
  CGP::internal::Conformal_deformation_options own;
  own.surface.scales.bound = problem.scale_bound;
  if (problem.mollification > 0) own.surface.mollification = problem.mollification;
  if (problem.position_weight) own.position_weight = *problem.position_weight;
  own.region = problem.region;
  CGP::internal::Conformal_deformation deformation(mesh, own, "deform");
  CGP::Spin_result result = deformation.deform(problem.points, std::cref(go_further));
  return {{std::move(result.positions), std::move(result.lambda), result.report},
          deformation.potential()};
}

}  // namespace conformal
