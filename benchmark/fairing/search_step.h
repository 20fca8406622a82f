// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/exceptions.h>

#include <cmath>
#include <optional>

#include "Method.h"

namespace cgp_benchmark {

constexpr int unlimited_steps = 1000000000;

/// a method with one time step, until its seconds are over
inline Run run_method(const Method& method, const CGP::Mesh_view& mesh, double time_step,
                      double seconds, int max_steps = unlimited_steps)
{
  Race race(mesh, seconds, max_steps);
  try {
    method.run(mesh, time_step, race);
  } catch (const CGP::Error& error) {
    race.fail(error.message());
  }
  Run run = std::move(race).result();
  run.time_step = time_step;
  return run;
}

struct Search {
  std::optional<Run> largest_stable;
  std::optional<Run> lowest;  // the one that ends with the least energy, stable or not
};

/// \brief tries the time steps 64, 32, 16, ... with all the seconds each.
///
/// Ends two steps below the largest stable one if smaller ones end with more energy than the best.
/// The largest stable one is then known up to the square root of 2.
inline Search search_step(const Method& method, const CGP::Mesh_view& mesh, double seconds)
{
  const double first = 64, last = std::ldexp(1., -80);
  Search search;
  int worse = 0;
  const auto attempt = [&](double time_step) {
    Run run = run_method(method, mesh, time_step, seconds);
    const bool is_lowest = run.steps > 0 && run.end != "not finite" &&
                           (!search.lowest || run.energy() < search.lowest->energy());
    worse = is_lowest ? 0 : worse + 1;
    if (is_lowest) search.lowest = run;
    return run;
  };
  for (double step = first; step > last && !(search.largest_stable && worse >= 2); step /= 2) {
    Run run = attempt(step);
    if (!run.is_stable || run.steps == 0 || search.largest_stable) continue;
    search.largest_stable = std::move(run);
    if (step == first) continue;
    Run larger = attempt(std::sqrt(2.) * step);
    if (larger.is_stable && larger.steps > 0) search.largest_stable = std::move(larger);
    worse = 0;
  }
  return search;
}

}  // namespace cgp_benchmark
