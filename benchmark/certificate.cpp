// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/Conformality.h>

#include "stage.h"

// All numbers of the report that measure the map.
static void certificate(benchmark::State& state)
{
  using namespace cgp_benchmark;
  const Mesh_view mesh = mesh_of(state);
  const CGP::Points normals = CGP::neighbourhood_normals(mesh);
  const CGP::Points moved = Eigen::Vector3d(1, 1.5, 0.7).asDiagonal() * mesh.positions();
  run_stage(state, mesh,
            [&] { benchmark::DoNotOptimize(CGP::conformality(mesh, moved, normals)); });
}
CGP_BENCHMARK(certificate);

BENCHMARK_MAIN();
