// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_CURVES_CURVE_FLOW_OPTIONS_H
#define CONFORMAL_GEOMETRY_PROCESSING_CURVES_CURVE_FLOW_OPTIONS_H

#include <Conformal_geometry_processing/exceptions.h>

#include <string>

namespace Conformal_geometry_processing {

/// \ingroup PkgCurves
/// how the ends of a closed curve are brought together after a step
enum class Curve_closing {
  exact,         ///< by a little more change of curvature: every edge keeps its length
  least_squares  ///< by a little change of all lengths, as in [CGP 6.4.3]
};

/// \ingroup PkgCurves
/// how to run an isometric curve flow
struct Curve_flow_options {
  /// whether the last point is followed by the first
  bool is_closed = true;

  /// tau in kappa + tau (-2 kappa, constrained). The flow is stable for 0 < tau < 1: it multiplies
  /// what can go away by 1 - 2 tau, so 1/2 goes furthest, and small ones show the way. Curves of
  /// turning number 0 are at rest only below about 3/4.
  double time_step = 0.5;

  int max_steps = 100;  ///< of one `run()`

  /// stop where the energy changes by less than this share of it in a time of 1; where it goes to
  /// zero, of a hundredth of what it was in the beginning
  double energy_tolerance = 1e-8;

  Curve_closing closing = Curve_closing::exact;
};

/// \relates Curve_flow_options
/// the options, if they are in their ranges
/// \throw Precondition_error naming `function` otherwise
const Curve_flow_options& checked(const Curve_flow_options& o, const std::string& function);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/curves/Curve_flow_options_impl.h>
#endif

#endif
