// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Row.h"
#include "support/Cholmod_poisson.h"
#include "support/memory.h"

namespace cgp_benchmark {

// The yardstick alone, with its stages and its memory.
static void measure_poisson(const Job& job, const CGP::Mesh_view& mesh, Record& record)
{
  Poisson_seconds seconds;
  const double bytes = peak_bytes([&] { seconds.measure(mesh); });
  repeat(job, [&] { seconds.measure(mesh); });
  record.add("assembly", seconds.assembly).add("symbolic", seconds.analysis);
  record.add("numeric", seconds.numeric).add("again", seconds.again).add("solve", seconds.solve);
  record.add("seconds", seconds.total).add("poisson", seconds.total).add("bytes", bytes);
}

void add_poisson(std::vector<Row>& rows)
{
  rows.push_back({"poisson", "CHOLMOD, real n", measure_poisson});
}

}  // namespace cgp_benchmark
