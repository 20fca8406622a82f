// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/curves/Isometric_curve_flow.h>

#include <benchmark/benchmark.h>

#include "support/clock.h"
#include "support/memory.h"
#include "support/plane_curves.h"

#include <algorithm>
#include <cmath>

namespace {

namespace CGP = Conformal_geometry_processing;
using namespace cgp_benchmark;

CGP::Curve_flow_options options_with(CGP::Curve_flow_options::Closing closing)
{
  CGP::Curve_flow_options options;
  options.time_step = 0.1;
  options.closing = closing;
  return options;
}

constexpr int steps = 10;

CGP::Curve_step_report flow(CGP::Isometric_curve_flow& curve)
{
  CGP::Curve_step_report report;
  for (int i = 0; i < steps; ++i) report = curve.step();
  return report;
}

/// The yardstick: the sine and the cosine of as many angles, which no step can do without.
double seconds_of_sines(const Eigen::VectorXd& angles)
{
  double least = never;
  Eigen::Matrix2Xd tangents(2, angles.size());
  for (int i = 0; i < 5; ++i)
    keep_least(least, [&] {
      for (Eigen::Index v = 0; v < angles.size(); ++v)
        tangents.col(v) = Eigen::Vector2d(std::cos(angles[v]), std::sin(angles[v]));
      benchmark::DoNotOptimize(tangents.data());
    });
  return least;
}

// A step of the first ten of a figure eight, the mean of the fastest run: where the flow moves most
// and closing takes its iterations.
void steps_of_a_curve(benchmark::State& state, CGP::Curve_flow_options::Closing closing)
{
  const auto m = static_cast<int>(state.range(0));
  const Eigen::Matrix2Xd points = cgp_test::figure_eight(m);
  const double yardstick = seconds_of_sines(Eigen::VectorXd::LinSpaced(m, -20, 20));
  double least = never, iterations = 0, distortion = 0;
  const double bytes = peak_bytes([&] {
    CGP::Isometric_curve_flow curve(points, options_with(closing));
    distortion = flow(curve).length_distortion;
  });
  for (auto _ : state) {
    CGP::Isometric_curve_flow curve(points, options_with(closing));
    keep_least(least, [&] { iterations = flow(curve).newton_iterations; });
  }
  state.counters["vertices"] = m;
  state.counters["steps_per_second"] = steps / least;
  state.counters["ratio"] = least / steps / yardstick;
  state.counters["newton_iterations"] = iterations;
  state.counters["length_distortion"] = distortion;
  state.counters["bytes_per_vertex"] = bytes / m;
}

}  // namespace

static void curve_flow(benchmark::State& state)
{
  steps_of_a_curve(state, CGP::Curve_flow_options::Closing::exact);
}
static void curve_flow_least_squares(benchmark::State& state)
{
  steps_of_a_curve(state, CGP::Curve_flow_options::Closing::least_squares);
}

#define CURVE_BENCHMARK(name)                                                                    \
  BENCHMARK(name)->Arg(200)->Arg(2000)->Arg(20000)->Arg(1000000)->MeasureProcessCPUTime()->Unit( \
      benchmark::kMillisecond)

CURVE_BENCHMARK(curve_flow);
CURVE_BENCHMARK(curve_flow_least_squares);

BENCHMARK_MAIN();
