// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

#include "stage.h"
#include "support/Double_solver_traits.h"
#include "support/Willmore_flow.h"
#include "support/workloads.h"

namespace {

using namespace cgp_benchmark;

// A later step of Willmore flow on a bumpy sphere: the mean of steps 2 to 5 of the fastest run. The
// memory is that of the whole flow.
void later_step(benchmark::State& state, double tau, const CGP::Spin_solvers& solvers = {})
{
  const Mesh_view mesh = in_unit_frame(bumpy_geodesic_sphere(static_cast<int>(state.range(0))));
  const int steps = 4;
  const double tolerance = 1e-6;
  const double yardstick = seconds_of_scalar_poisson(mesh);
  const double bytes = peak_bytes([&] {
    Willmore_flow flow(mesh, tolerance, solvers);
    for (int i = 0; i < 2; ++i) (void)flow.step(tau);
  });
  double least = never, iterations = 0, factorizations = 0;
  for (auto _ : state) {
    state.PauseTiming();
    Willmore_flow flow(mesh, tolerance, solvers);
    (void)flow.step(tau);
    iterations = factorizations = 0;
    state.ResumeTiming();
    keep_least(least, [&] {
      for (int i = 0; i < steps; ++i) {
        const CGP::Spin_report report = flow.step(tau);
        if (!report) state.SkipWithError("no convergence");
        iterations += report.iterations;
        factorizations += report.factorizations;
      }
    });
  }
  state.counters["vertices"] = mesh.size_of_vertices();
  state.counters["bytes_per_vertex"] = bytes / mesh.size_of_vertices();
  state.counters["ratio"] = least / steps / yardstick;
  state.counters["eigen_iterations"] = iterations / steps;
  state.counters["factorizations"] = factorizations / steps;
}

}  // namespace

static void flow_step(benchmark::State& state)
{
  later_step(state, 0.3);
}
static void flow_step_double(benchmark::State& state)
{
  later_step(state, 0.3, cgp_test::Double_solver_traits());
}

CGP_BENCHMARK(flow_step);
CGP_BENCHMARK(flow_step_double);

BENCHMARK_MAIN();
