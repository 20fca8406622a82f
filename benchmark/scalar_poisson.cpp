// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "stage.h"

// The yardstick: ordering, factorization and one solve of the scalar cotan Laplacian.
static void scalar_poisson(benchmark::State& state)
{
  const auto mesh = cgp_benchmark::mesh_of(state);
  cgp_benchmark::run_stage(
      state, mesh, [&] { benchmark::DoNotOptimize(cgp_benchmark::solve_scalar_poisson(mesh)); });
}
CGP_BENCHMARK(scalar_poisson);

BENCHMARK_MAIN();
