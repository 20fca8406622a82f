// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_CURVES_CURVE_FLOW_REPORT_IO_H
#define CONFORMAL_GEOMETRY_PROCESSING_CURVES_CURVE_FLOW_REPORT_IO_H

#include <Conformal_geometry_processing/curves/Curve_flow_report.h>

#include <iosfwd>

namespace Conformal_geometry_processing {

/// \relates Curve_flow_report
/// Writes the numbers of a flow, one fact per line, and why it is no success, if it is none
std::ostream& operator<<(std::ostream& out, const Curve_flow_report& r);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/curves/Curve_flow_report_io_impl.h>
#endif

#endif
