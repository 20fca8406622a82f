// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/curves/Curve_flow_report.h>

#include <iosfwd>

namespace Conformal_geometry_processing {

/// \relates Curve_flow_report
/// Writes the numbers of a flow, one fact per line, and why it is no success, if it is none
std::ostream& operator<<(std::ostream& out, const Curve_flow_report& r);

}  // namespace Conformal_geometry_processing
