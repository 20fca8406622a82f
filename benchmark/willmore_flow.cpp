// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// The first step of the conformal Willmore flow, including everything that is computed once
// (ordering, symbolic factorization, Laplacian, loops around handles), and the later ones without.
#include <Conformal_geometry_processing/flow/Conformal_willmore_flow.h>

#include <benchmark/benchmark.h>

#include <optional>

#include "support/clock.h"
#include "support/tori.h"
#include "support/workloads.h"

namespace {

using namespace cgp_benchmark;

/// The time of the benchmark is that of the whole run; the counters are the minima of its parts
void measure(benchmark::State& state, const CGP::Mesh_view& mesh)
{
  const int later_steps = 4;
  CGP::Flow_options options;
  options.surface.exact_conformal_class = false;
  options.time_step = 0.3;  // at 1, little would be left to do after two steps
  double first = never, later = never;
  int trials = 0;
  const auto step = [&](CGP::Conformal_willmore_flow& flow) {
    const CGP::Flow_step_report report = flow.step();
    if (!report.accepted) state.SkipWithError(to_string(report.stop));
    trials += report.trials;
  };
  for (auto _ : state) {
    std::optional<CGP::Conformal_willmore_flow> flow;
    trials = 0;
    keep_least(first, [&] {
      flow.emplace(mesh, options);
      step(*flow);
    });
    keep_least(later, [&] {
      for (int i = 0; i < later_steps; ++i) step(*flow);
    });
  }
  state.counters["faces"] = mesh.size_of_faces();
  state.counters["first_ms"] = 1000 * first;
  state.counters["later_ms"] = 1000 * later / later_steps;
  state.counters["later_by_first"] = later / later_steps / first;
  state.counters["trials"] = trials / (1. + later_steps);
}

}  // namespace

/// the argument is the frequency of the sphere: 20 frequency^2 faces
static void willmore_flow_sphere(benchmark::State& state)
{
  measure(state, in_unit_frame(bumpy_geodesic_sphere(static_cast<int>(state.range(0)))));
}

/// the argument is the number of vertices each way: 2 n^2 faces
static void willmore_flow_torus(benchmark::State& state)
{
  measure(state, cgp_test::btorus(static_cast<int>(state.range(0))));
}

BENCHMARK(willmore_flow_sphere)
    ->Arg(20)
    ->Arg(41)
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(willmore_flow_torus)
    ->Arg(64)
    ->Arg(129)
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
