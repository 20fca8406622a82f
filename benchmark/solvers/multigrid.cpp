// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/multigrid/Multigrid_solver.h>

#include "factors.h"
#include "transforms.h"

namespace cgp_benchmark {

void add_multigrid(std::vector<Row>& rows)
{
  using Quaternion = CGP::Quaternion<double>;
  using Multigrid = CGP::Multigrid_solver_traits;
  rows.push_back({"factor", "multigrid, real n", measure_factor<Multigrid::Solver<double>>});
  rows.push_back(
      {"factor", "multigrid, quaternion n", measure_factor<Multigrid::Solver<Quaternion>>});
  rows.push_back({"transform", "multigrid", measure_transform<Multigrid>});
}

}  // namespace cgp_benchmark
