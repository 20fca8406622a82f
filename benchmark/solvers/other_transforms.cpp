// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/adapters/Cholmod_hermitian_solver_traits.h>

#include "support/thesis_recipe.h"
#include "transforms.h"

namespace cgp_benchmark {

static void measure_thesis_recipe(const Job& job, const CGP::Mesh_view& mesh, Record& record)
{
  const CGP::Curvature_potential rho = smooth_potential(mesh, job.amplitude);
  measure_whole(job, mesh, record, [&] { return thesis_recipe(mesh, rho); });
  record.add("iterations", 3);
}

void add_other_transforms(std::vector<Row>& rows)
{
  rows.push_back({"transform", "CHOLMOD, complex 2n",
                  measure_transform<CGP::Cholmod_hermitian_solver_traits>, 300'000,
                  "takes minutes and 6 GB"});
  rows.push_back(
      {"transform", "thesis recipe", measure_thesis_recipe, 600'000, "takes minutes and 12 GB"});
}

}  // namespace cgp_benchmark
