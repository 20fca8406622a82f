// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

/// Measures how the distortion of spin transformations falls with the length of the edges, and that
/// of the conformal Willmore flow with the time step. Prints one line of JSON per mesh or time
/// step; `benchmark/measure_convergence` calls this and makes doc/convergence.md of it, and
/// `benchmark/measure_handles` doc/handles.md.
///
/// Usage: benchmark_convergence [space|time|handles]
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>

#include "convergence/measurements.h"

int main(int argc, char* argv[])
{
  try {
    const std::string what = argc > 1 ? argv[1] : "";
    if (what.empty() || what == "space") cgp_benchmark::measure_convergence_in_space();
    if (what.empty() || what == "time") cgp_benchmark::measure_convergence_in_time();
    if (what == "handles") cgp_benchmark::measure_handles();
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::cerr << "benchmark_convergence: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
