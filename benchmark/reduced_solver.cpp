// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/direct/sweep_nested_dissection.h>
#include <Quaternionic_linear_algebra/reduced/Reduced_hermitian_solver.h>
#include <Quaternionic_linear_algebra/reduced/Schur_reduced_solver.h>

#ifdef CONFORMAL_GEOMETRY_PROCESSING_USE_CHOLMOD
#include <Quaternionic_linear_algebra/adapters/Cholmod_hermitian_solver_traits.h>
#endif

#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
#include <limits>

#include "quaternionic_linear_algebra/reduced_problem.h"

/// Reduced systems of disks with random planes at the boundary; the argument is the number of rings
/// of the disk, which has 3 n^2 vertices and 6 n of them on its boundary. The second argument
/// chooses the mesh: 0 disk, 1 square, 2 annulus of radii 1 and 2, 3 cylinder, 4 annulus of
/// radii 1.5 and 2, 5 strip of 400 x n squares.
namespace {

namespace CGP = Conformal_geometry_processing;
using Quaternion = CGP::Quaternion<double>;

CGP::Mesh_view mesh_of(const benchmark::State& state)
{
  const int n = static_cast<int>(state.range(0));
  switch (state.range(1)) {
    case 1:
      return cgp_test::grid(2 * n, 2 * n, 2, 2);
    case 2:
      return cgp_test::annulus(2, 1, 6 * n, n);
    case 3:
      return cgp_test::cylinder(1, 6, 2 * n, 2 * n);
    case 4:
      return cgp_test::annulus(2, 1.5, 12 * n, n);
    case 5:
      return cgp_test::grid(400, n, 400, n);
    default:
      return cgp_test::disk(n);
  }
}

/// seconds of the processor, the least of several runs
template <class Action>
double seconds_of(Action action)
{
  double best = std::numeric_limits<double>::infinity();
  for (int run = 0; run < 4; ++run) {
    const std::clock_t begin = std::clock();
    action();
    best = std::min(best, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  return best;
}

/// The factorization, and its cost in units of the quaternionic factorization of the same X without
/// reduced rows
template <class Solver>
void factorization(benchmark::State& state)
{
  const CGP::Mesh_view mesh = mesh_of(state);
  const cgp_test::Reduced_problem p = cgp_test::reduced_problem(mesh, 1);
  const CGP::internal::Reduced_basis<double> basis = p.basis();
  CGP::Supernodal_cholesky<Quaternion> closed;
  Solver solver;
  if (closed.analyze_with_positions(p.X.pattern(), mesh.positions()) !=
          CGP::Solver_status::success ||
      solver.analyze(p.X.pattern(), basis.rows(),
                     CGP::sweep_nested_dissection(p.X.pattern(), mesh.positions())) !=
          CGP::Solver_status::success)
    return state.SkipWithError("the analysis failed");
  const auto b = cgp_test::random_block<Quaternion>(p.X.size(), 1, 2);
  CGP::Block<Quaternion> x;
  const double closed_factorization = seconds_of([&] { closed.factorize(p.X, p.shift); });
  const double closed_solution = seconds_of([&] { closed.solve(b, x); });
  const double factorization = seconds_of([&] { solver.factorize(p.X, p.shift, basis); });
  const double solution = seconds_of([&] { solver.solve(b, x); });
  for (auto _ : state) benchmark::DoNotOptimize(solver.factorize(p.X, p.shift, basis));
  state.counters["vertices"] = p.X.size();
  state.counters["reduced"] = basis.rows().size_of_reduced();
  state.counters["ratio"] = factorization / closed_factorization;
  state.counters["solve_ratio"] = solution / closed_solution;
  state.counters["solve_ms"] = 1e3 * solution;
  state.counters["bytes_per_vertex"] = solver.statistics().bytes / p.X.size();
  state.counters["gflops"] = 1e-9 * solver.statistics().flops / factorization;
}

void sizes(benchmark::internal::Benchmark* benchmark)
{
  for (const int n : {20, 40, 80, 160}) benchmark->Args({n, 0});
  for (const int mesh : {1, 2, 3, 4}) benchmark->Args({60, mesh});
  benchmark->Args({16, 5});
  benchmark->ArgNames({"n", "mesh"})->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
}

BENCHMARK_TEMPLATE(factorization, CGP::internal::Real_reduced_solver)->Apply(sizes);
BENCHMARK_TEMPLATE(factorization, CGP::internal::Schur_reduced_solver)->Apply(sizes);
#ifdef CONFORMAL_GEOMETRY_PROCESSING_USE_CHOLMOD
struct Real_by_cholmod : CGP::internal::Real_reduced_solver {
  Real_by_cholmod()
      : Real_reduced_solver(
            CGP::Spin_solvers(CGP::Cholmod_hermitian_solver_traits()).solver<double>())
  {}
};
BENCHMARK_TEMPLATE(factorization, Real_by_cholmod)->Apply(sizes);
#endif

}  // namespace

BENCHMARK_MAIN();
