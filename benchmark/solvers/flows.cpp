// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/templates.h>

#include "support/Willmore_flow.h"

#include <stdexcept>

#include "Row.h"
#include "support/Cholmod_poisson.h"

/// The table of flows: the cost of a later step, after all analysis.
namespace cgp_benchmark {

// The means of the steps 2 to 5, of the fastest run.
template <class SolverTraits>
static void measure_flow(const Job& job, const CGP::Mesh_view& mesh, Record& record)
{
  const double tau = 0.3;
  const int steps = 4;
  CGP::Dirac_options options;
  options.tolerance = job.tolerance;
  double seconds = never;
  int iterations = 0, factorizations = 0, poisson_iterations = 0, analyses = 0;
  Poisson_seconds floor;
  repeat(job, [&] {
    floor.measure(mesh);
    Willmore_flow<SolverTraits> flow(mesh);
    const auto step = [&] {
      const CGP::Spin_report report = flow.step(tau, options);
      if (!report) throw std::runtime_error("no convergence");
      return report.iterations;
    };
    step();
    const auto structure = factor_of(flow.eigensolver()).structure();
    const int before = factorizations_of(flow.eigensolver(), flow.steps());
    iterations = poisson_iterations = analyses = 0;
    keep_least(seconds, [&] {
      for (int i = 0; i < steps; ++i) {
        iterations += step();
        poisson_iterations = std::max(poisson_iterations, iterations_of(flow.poisson_solver()));
        if (factor_of(flow.eigensolver()).structure() != structure) ++analyses;
      }
    });
    factorizations = factorizations_of(flow.eigensolver(), flow.steps()) - before;
  });
  record.add("seconds", seconds / steps).add("poisson", floor.total).add("analyses", analyses);
  record.add("factorizations", double(factorizations) / steps);
  record.add("iterations", double(iterations) / steps);
  record.add("poisson_iterations", poisson_iterations);
}

void add_flows(std::vector<Row>& rows)
{
  using Double = CGP::Supernodal_solver_traits;
  using Float = CGP::Mixed_supernodal_solver_traits;
  const auto add = [&](const char* model, Row::Measure measure) {
    rows.push_back({"flow", model, measure, 300'000, "takes minutes"});
  };
  add("native, double", measure_flow<Double>);
  add("native, float", measure_flow<Float>);
  add("lagged, double", measure_flow<CGP::Lagged_solver_traits<Double>>);
  add("lagged, float", measure_flow<CGP::Lagged_solver_traits<Float>>);
}

}  // namespace cgp_benchmark
