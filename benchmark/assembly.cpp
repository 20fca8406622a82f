// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/dirac_energy.h>

#include "stage.h"

// The pattern of X and its values.
static void assembly(benchmark::State& state)
{
  const auto mesh = cgp_benchmark::mesh_of(state);
  const auto rho = cgp_benchmark::potential_of(mesh);
  cgp_benchmark::run_stage(state, mesh, [&] {
    benchmark::DoNotOptimize(Conformal_geometry_processing::dirac_energy(mesh, rho));
  });
}
CGP_BENCHMARK(assembly);

BENCHMARK_MAIN();
