// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Dirac_system.h>
#include <Quaternionic_linear_algebra/krylov/Lobpcg.h>

#include <cmath>
#include <utility>

#include "stage.h"

// The eigenvector from lambda = 1, with the factorization at hand.
static void eigenpair(benchmark::State& state)
{
  using namespace cgp_benchmark;
  const Mesh_view mesh = mesh_of(state);
  CGP::internal::Dirac_system system(mesh);
  CGP::internal::Dirac_evidence::Seconds seconds;
  system.set_potential(potential_of(mesh), seconds);
  const auto one =
      CGP::Quaternion_vector<double>::Constant(mesh.size_of_vertices(), {1, 0, 0, 0}).eval();
  CGP::Eigensolver_options options;
  options.tolerance = CGP::Dirac_options().tolerance;
  options.max_iterations = 200;
  options.scale = std::sqrt(system.unit());
  CGP::Eigensolver_result result;
  run_stage(state, mesh, [&] {
    CGP::Block<CGP::Quaternion<double>> start(one.size(), 2);
    start << one, system.noise(1, 0);
    result = CGP::Lobpcg_eigensolver_traits()(system.matrix(), system.areas(), system.solver(),
                                              std::move(start), options,
                                              CGP::internal::Always_go_further());
  });
  if (!result.converged) state.SkipWithError("no convergence");
  state.counters["eigen_iterations"] = result.iterations;
}
CGP_BENCHMARK(eigenpair);

BENCHMARK_MAIN();
