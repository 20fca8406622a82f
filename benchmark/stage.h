// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Quaternionic_linear_algebra/direct/Default_solver_traits.h>

#include <benchmark/benchmark.h>

#include "support/Cholmod_poisson.h"
#include "support/clock.h"
#include "support/memory.h"
#include "support/spheres.h"

/// Common functions of the benchmarks of all stages: mesh, yardstick and counters. The
/// argument is the frequency of a geodesic sphere, which has 10 frequency^2 + 2 vertices.
namespace cgp_benchmark {

namespace CGP = Conformal_geometry_processing;
using CGP::Curvature_potential;
using CGP::Mesh_view;

/// the frequency that the benchmark was called with
inline Mesh_view mesh_of(const benchmark::State& state)
{
  return cgp_test::geodesic_sphere(static_cast<int>(state.range(0)));
}

inline Curvature_potential potential_of(const Mesh_view& mesh)
{
  return Curvature_potential::on_vertices(cgp_test::rho_of_section_3_on_vertices(mesh));
}

/// One scalar Poisson problem on the mesh by CHOLMOD: assembly, ordering, factorization and one
/// solve with three right-hand sides; a lower bound for all known methods
inline Eigen::MatrixXd solve_scalar_poisson(const Mesh_view& mesh)
{
  Cholmod_poisson poisson(mesh);
  poisson.analyze();
  poisson.factorize();
  return poisson.solve(mesh.positions().transpose());
}

/// the yardstick in seconds of the processor, the best of three
inline double seconds_of_scalar_poisson(const Mesh_view& mesh)
{
  double best = never;
  for (int i = 0; i < 3; ++i)
    keep_least(best, [&] { benchmark::DoNotOptimize(solve_scalar_poisson(mesh)); });
  return best;
}

/// Measures `stage()`: processor time, peak memory above the initial one, and the ratio to the
/// yardstick on the same mesh in the same run
template <class Stage>
void run_stage(benchmark::State& state, const Mesh_view& mesh, Stage stage)
{
  const double bytes = peak_bytes(stage);
  const double yardstick = seconds_of_scalar_poisson(mesh);
  const double start = cpu_seconds();
  for (auto _ : state) stage();
  const double seconds = (cpu_seconds() - start) / static_cast<double>(state.iterations());
  state.counters["vertices"] = mesh.size_of_vertices();
  state.counters["bytes_per_vertex"] = bytes / mesh.size_of_vertices();
  state.counters["ratio"] = seconds / yardstick;
}

inline void count_factor_entries(benchmark::State& state, const CGP::Solver_statistics& s)
{
  state.counters["factor_entries"] = static_cast<double>(s.factor_entries);
}

}  // namespace cgp_benchmark

/// registers the stage for three sizes; `--benchmark_filter=/20/` takes the first alone
#define CGP_BENCHMARK(stage)                                                  \
  BENCHMARK(stage)->Arg(20)->Arg(41)->Arg(81)->MeasureProcessCPUTime()->Unit( \
      benchmark::kMillisecond)
