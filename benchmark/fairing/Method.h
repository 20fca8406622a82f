// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "Fairing_flow.h"
#include "Race.h"
#include "unit_frame.h"

namespace cgp_benchmark {

/// a fairing method: runs on a mesh with a time step until the race stops it
struct Method {
  std::string name;
  std::function<void(const CGP::Mesh_view&, double time_step, Race&)> run;
};

/// \brief Steps, each followed by scaling to the area 4 pi about the centroid.
///
/// The thesis' flows of positions shrink; the measures are scale-invariant, and scaling keeps the
/// meaning of time.
template <class Flow>
void run_steps(const CGP::Mesh_view& mesh, double time_step, Surface_observer& observer)
{
  Flow flow(mesh, time_step);
  do {
    flow.step();
    flow.set_positions(positions_in_unit_frame(flow.mesh()));
  } while (observer(flow.mesh().positions()));
}

/// (M + tau / 2 L_0) f' = M f as CGAL has it
void run_smooth_shape(const CGP::Mesh_view& mesh, double time_step, Surface_observer& observer);

/// with the time step given, or half of it where that is too large
void run_conformal_willmore(const CGP::Mesh_view& mesh, double time_step, Race& race);

/// all others, each with one time step for all steps
std::vector<Method> competing_methods();

/// prints what each method does where that is known in closed form
/// \returns whether all is as it should be
bool check_methods();

}  // namespace cgp_benchmark
