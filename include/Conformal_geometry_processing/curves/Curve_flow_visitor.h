// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/curves/Curve_flow_report.h>
#include <Conformal_geometry_processing/curves/Polygon_lengths.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgCurves
/// \brief A model of `CurveFlowVisitor` that does nothing; derive from it to override functions.
///
/// Exceptions propagate to the caller; the flow remains at its last complete step.
struct Curve_flow_visitor {
  /// Called once, with the initial curve, 2 x m, and its energy
  void on_flow_begin(const internal::Plane_points&, double) {}

  /// Called before every step; false stops the flow
  bool go_further() { return true; }

  /// Called after every accepted step, with the new curve
  void on_step_end(const Curve_step_report&, const internal::Plane_points&) {}
};

}  // namespace Conformal_geometry_processing
