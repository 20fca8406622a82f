// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/report/Outcome.h"

#include <Conformal_geometry_processing/flow/Flow_report.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <string>

namespace conformal {

/// the surface after the last complete step, for the faces of the input, and the report
struct Flow_solution {
  CGP::Points positions;
  CGP::Flow_report report;
};

/// why the flow has stopped, in words
std::string reason(const CGP::Flow_report& report);

/// Tells the steps of a flow, and what came of it.
/// \param evidence of all steps
void tell_flow(const Flow_solution& solution, const CGP::Mesh_view& initial,
               const CGP::Spin_report& evidence, Outcome& outcome);

}  // namespace conformal
