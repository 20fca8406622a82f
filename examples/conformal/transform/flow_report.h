// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_TRANSFORM_FLOW_REPORT_H
#define CONFORMAL_TRANSFORM_FLOW_REPORT_H

#include "run_flow.h"

#include "conformal/report/Grid.h"
#include "conformal/report/Report.h"
#include "conformal/report/Table.h"

#include <string>

namespace conformal {

/// why the flow has stopped, in words
std::string reason(const CGP::Flow_report& report);

/// Enters a flow into the report (`result/...`, `steps/...`, `seconds/...`).
/// \param evidence of all steps
void report_flow(const Flow_solution& solution, const CGP::Mesh_view& initial,
                 const CGP::Spin_report& evidence, Report& report);

/// the steps, a line each
Grid step_grid(const CGP::Flow_report& report);

/// the whole flow for the eye
Table flow_table(const Flow_solution& solution, const CGP::Mesh_view& initial,
                 const CGP::Spin_report& evidence);

}  // namespace conformal

#endif
