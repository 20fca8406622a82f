// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Dirac_system.h>
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>

#include <optional>

#include "stage.h"

// The factorization of the Laplacian, with the ordering that X has found.
static void poisson_factor(benchmark::State& state)
{
  using namespace cgp_benchmark;
  const Mesh_view mesh = mesh_of(state);
  const CGP::internal::Dirac_system system(mesh);
  std::optional<CGP::Poisson_reconstruction> reconstruction;
  run_stage(state, mesh, [&] {
    reconstruction.emplace(mesh, system.matrix().shared_pattern(), system.solver());
  });
  count_factor_entries(state, reconstruction->statistics());
}
CGP_BENCHMARK(poisson_factor);

BENCHMARK_MAIN();
