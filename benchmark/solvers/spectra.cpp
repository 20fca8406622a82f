// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Dirac_spectrum.h>

#include "Row.h"
#include "support/Cholmod_poisson.h"
#include "support/workloads.h"

/// The table of spectra: the first ten eigenvalues of D and of D - rho, on a mesh never seen
/// before.
namespace cgp_benchmark {

template <bool has_potential>
static void measure_spectrum(const Job& job, const CGP::Mesh_view& mesh, Record& record)
{
  const int count = 10;
  const CGP::Curvature_potential rho =
      has_potential ? smooth_potential(mesh, job.amplitude) : CGP::no_potential(mesh);
  double seconds = never;
  Poisson_seconds floor;
  CGP::internal::Dirac_spectrum found;
  repeat(job, [&] {
    floor.measure(mesh);
    keep_least(seconds,
               [&] { found = CGP::internal::Dirac_spectral_problem(mesh).find(rho, count); });
  });
  record.add("seconds", seconds).add("poisson", floor.total).add("restarts", found.restarts);
  record.add("converged", found.converged).add("complete", found.is_complete());
}

void add_spectra(std::vector<Row>& rows)
{
  const auto add = [&](const char* model, Row::Measure measure) {
    rows.push_back({"spectrum", model, measure, 300'000, "takes a minute"});
  };
  add("D", measure_spectrum<false>);
  add("D - rho", measure_spectrum<true>);
}

}  // namespace cgp_benchmark
