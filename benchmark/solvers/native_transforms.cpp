// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/krylov/inverse_power_method.h>

#include "support/Double_solver_traits.h"
#include "transforms.h"

namespace cgp_benchmark {

// Not measured but made: the positions that all others are compared to.
static void make_reference(const Job& job, const CGP::Mesh_view& mesh, Record& record)
{
  CGP::Spin_transformation_options own;
  own.dirac.tolerance = 1e-12;
  own.solvers = cgp_test::Double_solver_traits();
  const CGP::Spin_result result =
      CGP::Spin_transformation(mesh, own).transform(smooth_potential(mesh, job.amplitude));
  write_positions(job.reference, result.positions);
  record.add("residual", result.report.residual).add("gap", result.report.gap);
  record.add("iterations", result.report.iterations);
}

void add_native_transforms(std::vector<Row>& rows)
{
  rows.push_back(
      {"reference", "native, double, 1e-12", make_reference, 1'500'000, "takes minutes"});
  rows.push_back(
      {"transform", "native, double", measure_transform<cgp_test::Double_solver_traits>});
  rows.push_back({"transform", "native, float", measure_transform<CGP::Supernodal_solver_traits>});
  rows.push_back(
      {"transform", "native, inverse power method",
       measure_transform<CGP::Supernodal_solver_traits, CGP::Inverse_power_eigensolver_traits>});
}

}  // namespace cgp_benchmark
