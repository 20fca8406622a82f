// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Flow_options.h"
#include "Flow_watch.h"

#include <Conformal_geometry_processing/flow/Flow_report.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

namespace conformal {

/// Result of the library: the surface after the last complete step, and the report
struct Flow_solution {
  CGP::Points positions;
  CGP::Flow_report report;
};

/// Calls the library's `Conformal_willmore_flow`. This is the one place that compiles it.
Flow_solution run_flow(const CGP::Mesh_view& mesh, const Flow_options& options, Flow_watch& watch);

}  // namespace conformal
