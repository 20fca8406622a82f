// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Dirac_eigenproblem.h>

#include "stage.h"

// The eigenvector from lambda = 1, with the factorization at hand.
static void eigenpair(benchmark::State& state)
{
  using namespace cgp_benchmark;
  const Mesh_view mesh = mesh_of(state);
  CGP::Dirac_eigenproblem<> problem(mesh);
  CGP::Dirac_solution::Seconds seconds;
  problem.set_potential(potential_of(mesh), seconds);
  const auto one =
      CGP::Quaternion_vector<double>::Constant(mesh.size_of_vertices(), {1, 0, 0, 0}).eval();
  CGP::Eigensolver_result result;
  run_stage(state, mesh, [&] {
    result = problem.smallest(problem.start(one, 0), 1, CGP::Dirac_options().tolerance, 200,
                              CGP::Always_go_further());
  });
  if (!result.converged) state.SkipWithError("no convergence");
  state.counters["eigen_iterations"] = result.iterations;
}
CGP_BENCHMARK(eigenpair);

BENCHMARK_MAIN();
