// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef BENCHMARK_STAGE_H
#define BENCHMARK_STAGE_H

#include <Conformal_geometry_processing/linear_algebra/Cholmod_hermitian_solver_traits.h>
#include <Conformal_geometry_processing/linear_algebra/Default_solver_traits.h>
#include <Conformal_geometry_processing/linear_algebra/Grounded_solver.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>

#include <benchmark/benchmark.h>

#include <malloc.h>

#include <algorithm>
#include <ctime>
#include <fstream>
#include <limits>
#include <string>

#include "support/spheres.h"

/// What the benchmarks of all stages share: the mesh, the yardstick and the counters. The argument
/// is the frequency of a geodesic sphere, which has 10 frequency^2 + 2 vertices.
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

/// seconds of the processor, of all threads of this program
inline double cpu_seconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// a line of /proc/self/status, in bytes: "VmRSS:" is the memory in use, "VmHWM:" its peak
inline double bytes_of(const std::string& line)
{
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (word == line) {
      double kilobytes = 0;
      status >> kilobytes;
      return 1024 * kilobytes;
    }
  return 0;
}

/// the peak of memory while `stage()` runs, above what was in use before
template <class Stage>
double peak_bytes(Stage stage)
{
  malloc_trim(0);                               // gives back what earlier stages have freed
  std::ofstream("/proc/self/clear_refs") << 5;  // the peak begins anew
  const double before = bytes_of("VmRSS:");
  stage();
  return bytes_of("VmHWM:") - before;
}

/// one scalar Poisson problem on the mesh by CHOLMOD: assembly, ordering, factorization and one
/// solve with three right-hand sides; the floor for any method that people know
inline Eigen::MatrixXd solve_scalar_poisson(const Mesh_view& mesh)
{
  const auto pattern = CGP::vertex_graph(mesh);
  CGP::Grounded_solver<CGP::Cholmod_hermitian_solver_traits> solver(pattern);
  solver.factorize(CGP::cotan_laplacian(mesh, pattern));
  return solver.solve(mesh.positions().transpose());
}

/// the yardstick in seconds of the processor, the best of three
inline double seconds_of_scalar_poisson(const Mesh_view& mesh)
{
  double best = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const double start = cpu_seconds();
    benchmark::DoNotOptimize(solve_scalar_poisson(mesh));
    best = std::min(best, cpu_seconds() - start);
  }
  return best;
}

/// measures `stage()`: time of the processor, peak memory above what was there before, and the
/// ratio to the yardstick on the same mesh in the same run
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

#endif
