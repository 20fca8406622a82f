// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include "stage.h"

// Everything: checks, setup, eigenvector, positions and certificate.
static void spin_transform(benchmark::State& state)
{
  using namespace cgp_benchmark;
  const Mesh_view mesh = mesh_of(state);
  const Curvature_potential rho = potential_of(mesh);
  CGP::Spin_report report;
  run_stage(state, mesh, [&] { report = CGP::Spin_transformation(mesh).transform(rho).report; });
  if (!report) state.SkipWithError("no convergence");
  state.counters["eigen_iterations"] = report.iterations;
}
CGP_BENCHMARK(spin_transform);

BENCHMARK_MAIN();
