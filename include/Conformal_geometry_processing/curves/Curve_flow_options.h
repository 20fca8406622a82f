// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/exceptions.h>

#include <string>

namespace Conformal_geometry_processing {

/// \ingroup PkgCurves
/// Options of an isometric curve flow
struct Curve_flow_options {
  /// How the ends of a closed curve are joined after a step
  enum class Closing {
    exact,         ///< by an additional change of curvature: every edge keeps its length
    least_squares  ///< by small changes of all lengths, as in [CGP 6.4.3]
  };

  /// Whether the last point is followed by the first
  bool is_closed = true;

  /// tau in kappa + tau (-2 kappa, constrained). The flow is stable for 0 < tau < 1: each step
  /// multiplies the removable part of the curvature by 1 - 2 tau, so 1/2 converges fastest, and
  /// small values show the evolution. Curves of turning number 0 converge only below about 3/4.
  double time_step = 0.5;

  int max_steps = 100;  ///< of one `run()`

  /// Relative change of the energy per unit of time below which the flow stops; relative to the
  /// energy or, if it tends to zero, to a hundredth of the initial energy
  double energy_tolerance = 1e-8;

  Closing closing = Closing::exact;
};

/// \relates Curve_flow_options
/// Returns the options
/// \throw Precondition_error naming `function` if an option is out of its range
const Curve_flow_options& checked(const Curve_flow_options& o, const std::string& function);

}  // namespace Conformal_geometry_processing
