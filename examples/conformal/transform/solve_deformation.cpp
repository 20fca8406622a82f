// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "solve_deformation.h"

#include <utility>

namespace conformal {

Deformation_solution solve_deformation(
    const CGP::Mesh_view& mesh, const Deformation_problem& problem,
    const std::function<bool(const CGP::Eigensolver_progress&)>& go_further)
{
  CGP::internal::Conformal_deformation deformation(mesh, problem.request, "deform");
  CGP::Spin_result result = deformation.deform(problem.points, std::cref(go_further));
  return {{std::move(result)}, deformation.potential(), deformation.region()};
}

}  // namespace conformal
