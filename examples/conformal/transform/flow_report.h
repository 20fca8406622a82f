// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

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
