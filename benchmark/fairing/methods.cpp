// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Method.h"
#include "conformal_willmore.h"
#include "discrete_willmore.h"
#include "explicit_flows.h"
#include "implicit_bi_laplacian.h"
#include "implicit_mean_curvature.h"
#include "isometric_bending.h"
#include "modified_mean_curvature.h"
#include "volume_controlled_mean_curvature.h"

namespace cgp_benchmark {
namespace {

void run_flow(const CGP::Mesh_view& mesh, double time_step, bool backtracking, Race& race)
{
  Conformal_willmore flow(mesh, time_step, backtracking);
  const auto has_stopped = [&] { return flow.stop() != CGP::Flow_step_report::Stop::none; };
  bool goes_on = true;
  while (goes_on && flow.step()) goes_on = race(flow.mesh().positions()) && !has_stopped();
  if (has_stopped()) race.finish(to_string(flow.stop()));
}

}  // namespace

void run_conformal_willmore(const CGP::Mesh_view& mesh, double time_step, Race& race)
{
  run_flow(mesh, time_step, true, race);
}

std::vector<Method> competing_methods()
{
  return {{"explicit mean curvature", run_steps<Explicit_mean_curvature>},
          {"explicit bi-Laplacian", run_steps<Explicit_bi_laplacian>},
          {"implicit mean curvature", run_steps<Implicit_mean_curvature>},
          {"implicit bi-Laplacian", run_steps<Implicit_bi_laplacian>},
          {"modified mean curvature", run_steps<Modified_mean_curvature>},
          {"smooth_shape of CGAL", run_smooth_shape},
          {"volume-controlled mean curvature", run_steps<Volume_controlled_mean_curvature>},
          {"discrete Willmore", run_steps<Discrete_willmore<1>>},
          {"discrete Willmore, 16 fold", run_steps<Discrete_willmore<16>>},
          {"isometric bending", run_steps<Isometric_bending>},
          {"isometric bending, metric kept", run_steps<Isometric_bending_of_the_input>},
          {"ours, one time step", [](const CGP::Mesh_view& mesh, double time_step, Race& race) {
             run_flow(mesh, time_step, false, race);
           }}};
}

}  // namespace cgp_benchmark
