// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

#include "support/Double_solver_traits.h"
#include "support/Willmore_flow.h"

#include <stdexcept>

#include "Row.h"
#include "support/Cholmod_poisson.h"

/// The table of flows: the cost of a later step, after all analysis.
namespace cgp_benchmark {

const int steps = 4;  // after the first one

// The largest of 0.3, 0.15, ... whose steps are all verified: features of a scan limit it.
static double verified_time_step(const CGP::Mesh_view& mesh, const CGP::Spin_solvers& solvers,
                                 double tolerance)
{
  for (double tau = 0.3; tau > 1e-3; tau /= 2) {
    Willmore_flow flow(mesh, tolerance, solvers);
    int verified = 0;
    while (verified <= steps && flow.step(tau)) ++verified;
    if (verified > steps) return tau;
  }
  throw std::runtime_error("no flow with verified steps");
}

// The means of the steps 2 to 5, of the fastest run.
template <class SolverTraits>
static void measure_flow(const Job& job, const CGP::Mesh_view& mesh, Record& record)
{
  const double tau = verified_time_step(mesh, SolverTraits(), job.tolerance);
  double seconds = never;
  int iterations = 0, factorizations = 0;
  Poisson_seconds floor;
  repeat(job, [&] {
    floor.measure(mesh);
    Willmore_flow flow(mesh, job.tolerance, SolverTraits());
    flow.step(tau);
    iterations = factorizations = 0;
    keep_least(seconds, [&] {
      for (int i = 0; i < steps; ++i) {
        const CGP::Spin_report report = flow.step(tau);
        iterations += report.iterations;
        factorizations += report.factorizations;
      }
    });
  });
  record.add("tau", tau);
  record.add("seconds", seconds / steps).add("poisson", floor.total);
  record.add("factorizations", double(factorizations) / steps);
  record.add("iterations", double(iterations) / steps);
}

void add_flows(std::vector<Row>& rows)
{
  const auto add = [&](const char* model, Row::Measure measure) {
    rows.push_back({"flow", model, measure, 300'000, "takes minutes"});
  };
  add("native, double", measure_flow<cgp_test::Double_solver_traits>);
  add("native, float", measure_flow<CGP::Default_solver_traits>);
}

}  // namespace cgp_benchmark
