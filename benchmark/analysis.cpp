// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>

#include <optional>

#include "stage.h"

// The ordering of the vertices and the symbolic factorization of X.
static void analysis(benchmark::State& state)
{
  using namespace cgp_benchmark;
  using Solver = CGP::Default_solver_traits::Solver<CGP::Quaternion<double>>;
  const Mesh_view mesh = mesh_of(state);
  const auto pattern = CGP::vertex_graph(mesh);
  std::optional<Solver> solver;
  run_stage(state, mesh, [&] {
    solver.emplace();
    benchmark::DoNotOptimize(solver->analyze_with_positions(*pattern, mesh.positions()));
  });
  count_factor_entries(state, solver->statistics());
}
CGP_BENCHMARK(analysis);

BENCHMARK_MAIN();
