// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "run_flow.h"

#include <Conformal_geometry_processing/flow/Conformal_willmore_flow.h>

#include <cmath>

namespace conformal {
Flow_solution run_flow(const CGP::Mesh_view& mesh, const Flow_options& options, Flow_watch& watch)
{
  CGP::Flow_options request = options.request;
  if (options.force) request.surface.limits.map = {HUGE_VAL, HUGE_VAL, HUGE_VAL};
  CGP::Conformal_willmore_flow flow(mesh, request, {}, "flow");
  CGP::Flow_report report = flow.run(watch);
  return {flow.positions(), std::move(report)};
}

}  // namespace conformal
