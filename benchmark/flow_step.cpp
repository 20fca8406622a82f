// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/templates.h>

#include "stage.h"
#include "support/Willmore_flow.h"
#include "support/workloads.h"

#include <algorithm>

namespace {

using namespace cgp_benchmark;

// A later step of Willmore flow on a bumpy sphere: the mean of steps 2 to 5 of the fastest run. The
// memory is that of the whole flow.
template <class SolverTraits>
void later_step(benchmark::State& state, double tau)
{
  const Mesh_view mesh = in_unit_frame(bumpy_geodesic_sphere(static_cast<int>(state.range(0))));
  const int steps = 4;
  CGP::Dirac_options options;
  options.tolerance = 1e-6;
  const double yardstick = seconds_of_scalar_poisson(mesh);
  const double bytes = peak_bytes([&] {
    Willmore_flow<SolverTraits> flow(mesh);
    for (int i = 0; i < 2; ++i) (void)flow.step(tau, options);
  });
  double least = never, iterations = 0, factorizations = 0, poisson = 0;
  for (auto _ : state) {
    state.PauseTiming();
    Willmore_flow<SolverTraits> flow(mesh);
    (void)flow.step(tau, options);
    const int before = factorizations_of(flow.eigensolver(), flow.steps());
    iterations = poisson = 0;
    state.ResumeTiming();
    keep_least(least, [&] {
      for (int i = 0; i < steps; ++i) {
        const CGP::Spin_report report = flow.step(tau, options);
        if (!report) state.SkipWithError("no convergence");
        iterations += report.iterations;
        poisson = std::max<double>(poisson, iterations_of(flow.poisson_solver()));
      }
    });
    factorizations = factorizations_of(flow.eigensolver(), flow.steps()) - before;
  }
  state.counters["vertices"] = mesh.size_of_vertices();
  state.counters["bytes_per_vertex"] = bytes / mesh.size_of_vertices();
  state.counters["ratio"] = least / steps / yardstick;
  state.counters["eigen_iterations"] = iterations / steps;
  state.counters["factorizations"] = factorizations / steps;
  state.counters["poisson_iterations"] = poisson;
}

using Double_traits = CGP::Supernodal_solver_traits;
using Float_traits = CGP::Mixed_supernodal_solver_traits;

}  // namespace

static void flow_step(benchmark::State& state)
{
  later_step<Double_traits>(state, 0.3);
}
static void flow_step_float(benchmark::State& state)
{
  later_step<Float_traits>(state, 0.3);
}
static void flow_step_lagged(benchmark::State& state)
{
  later_step<CGP::Lagged_solver_traits<Double_traits>>(state, 0.3);
}
static void flow_step_float_lagged(benchmark::State& state)
{
  later_step<CGP::Lagged_solver_traits<Float_traits>>(state, 0.3);
}
// so small a step that the factor of the first serves them all
static void flow_step_small_lagged(benchmark::State& state)
{
  later_step<CGP::Lagged_solver_traits<Double_traits>>(state, 0.03);
}

CGP_BENCHMARK(flow_step);
CGP_BENCHMARK(flow_step_float);
CGP_BENCHMARK(flow_step_lagged);
CGP_BENCHMARK(flow_step_float_lagged);
CGP_BENCHMARK(flow_step_small_lagged);

BENCHMARK_MAIN();
