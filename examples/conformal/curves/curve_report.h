// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_CURVES_CURVE_REPORT_H
#define CONFORMAL_CURVES_CURVE_REPORT_H

#include "Curve_flows.h"

#include "conformal/report/Grid.h"
#include "conformal/report/Report.h"

#include <string>

namespace conformal {

/// why the flow of a curve has stopped, in words
std::string reason(const Curve_flows::One& one);

/// Enters the curves into the report: `input/curves`, `result/...`; what each has is a list, a
/// number per curve, and so are the numbers of a step, which are null for a curve at rest.
void report_curves(const Curve_flows& flows, Report& report);

/// the steps of a single curve, a line each
Grid step_grid(const Curve_flows::One& one);

/// a line for each curve
Grid curve_grid(const Curve_flows& flows);

}  // namespace conformal

#endif
