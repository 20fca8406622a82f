// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>

#include "stage.h"

// Positions from lambda: new edges, divergence, one solve with three right-hand sides.
static void reconstruction(benchmark::State& state)
{
  using namespace cgp_benchmark;
  const Mesh_view mesh = mesh_of(state);
  const CGP::Poisson_reconstruction poisson(mesh, CGP::vertex_graph(mesh));
  const auto lambda =
      CGP::Quaternion_vector<double>::Constant(mesh.size_of_vertices(), {1, 0.5, 0, 0}).eval();
  run_stage(state, mesh, [&] {
    benchmark::DoNotOptimize(poisson.positions(CGP::transformed_edges(mesh, lambda)));
  });
}
CGP_BENCHMARK(reconstruction);

BENCHMARK_MAIN();
