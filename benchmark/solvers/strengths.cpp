// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// What edits of several strengths cost, as they are and with a bound on the factors of lengths:
// factorizations, solves, time, and whether they come out.

#include "transforms.h"

namespace cgp_benchmark {

template <int hundredths, bool is_bounded = false>
static void measure_strength(const Job& job, const CGP::Mesh_view& mesh, Record& record)
{
  Job stronger = job;
  stronger.amplitude = hundredths / 100.;
  if (is_bounded) stronger.bound = 2;
  record.add("amplitude", stronger.amplitude);
  measure_transform<CGP::Default_solver_traits>(stronger, mesh, record);
}

void add_strengths(std::vector<Row>& rows)
{
  rows.push_back({"strength", "0.5", measure_strength<50>});
  rows.push_back({"strength", "1", measure_strength<100>});
  rows.push_back({"strength", "2", measure_strength<200>});
  rows.push_back({"strength", "4", measure_strength<400>});
  rows.push_back({"bounded", "1.5", measure_strength<150, true>});
  rows.push_back({"bounded", "3", measure_strength<300, true>});
}

}  // namespace cgp_benchmark
