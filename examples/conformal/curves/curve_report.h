// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_CURVES_CURVE_REPORT_H
#define CONFORMAL_CURVES_CURVE_REPORT_H

#include "Curve_flows.h"

#include "conformal/report/Report.h"

namespace conformal {

/// Tells what came of the curves, and the steps of a single one.
void tell_curves(const Curve_flows& flows, Report& report);

}  // namespace conformal

#endif
