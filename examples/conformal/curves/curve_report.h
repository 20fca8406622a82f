// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Curve_flows.h"

#include "conformal/report/Report.h"

namespace conformal {

/// Tells what came of the curves, and the steps of a single one.
void tell_curves(const Curve_flows& flows, Report& report);

}  // namespace conformal
