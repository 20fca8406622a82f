// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include "stage.h"

// The numeric factorization of X as a preconditioner, which is in single precision.
static void factorization(benchmark::State& state)
{
  using namespace cgp_benchmark;
  const Mesh_view mesh = mesh_of(state);
  const auto X = CGP::dirac_energy(mesh, potential_of(mesh));
  const Eigen::VectorXd shift = 1e-3 * CGP::vertex_areas(mesh);
  CGP::Default_solver_traits::Solver<CGP::Quaternion<double>> solver;
  if (solver.analyze_with_positions(X.pattern(), mesh.positions()) != CGP::Solver_status::success)
    return state.SkipWithError("the analysis failed");
  run_stage(state, mesh,
            [&] { benchmark::DoNotOptimize(solver.factorize_preconditioner(X, shift)); });
  count_factor_entries(state, solver.statistics());
}
CGP_BENCHMARK(factorization);

BENCHMARK_MAIN();
