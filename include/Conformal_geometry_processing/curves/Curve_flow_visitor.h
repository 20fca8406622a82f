// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_CURVES_CURVE_FLOW_VISITOR_H
#define CONFORMAL_GEOMETRY_PROCESSING_CURVES_CURVE_FLOW_VISITOR_H

#include <Conformal_geometry_processing/curves/Curve_flow_report.h>
#include <Conformal_geometry_processing/curves/Polygon_lengths.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgCurves
/// \brief a model of `CurveFlowVisitor` that watches without a word; derive from it to override
/// one.
///
/// Whatever it throws passes through; the flow is at its last complete step then.
struct Curve_flow_visitor {
  /// called once, with the curve the flow starts from, 2 x m, and its energy
  void on_flow_begin(const Plane_points&, double) {}

  /// asked before every step: false stops the flow
  bool go_further() { return true; }

  /// called after every accepted step, with the new curve
  void on_step_end(const Curve_step_report&, const Plane_points&) {}
};

}  // namespace Conformal_geometry_processing

#endif
