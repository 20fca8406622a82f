// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_TRANSFORM_FLOW_REPORT_H
#define CONFORMAL_TRANSFORM_FLOW_REPORT_H

#include "run_flow.h"

#include "conformal/report/Outcome.h"

#include <string>

namespace conformal {

/// why the flow has stopped, in words
std::string reason(const CGP::Flow_report& report);

/// Tells the steps of a flow, and what came of it.
/// \param evidence of all steps
void tell_flow(const Flow_solution& solution, const CGP::Mesh_view& initial,
               const CGP::Spin_report& evidence, Outcome& outcome);

}  // namespace conformal

#endif
