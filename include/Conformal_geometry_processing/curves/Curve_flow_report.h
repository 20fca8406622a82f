// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgCurves
/// \brief Measurements of one step of a curve flow.
struct [[nodiscard]] Curve_step_report {
  /// Reason why a curve flow has stopped
  enum class Stop {
    none,            ///< it has not stopped
    energy_settled,  ///< the energy changes by less than the tolerance
    steps_done,      ///< the requested steps are done
    cancelled,       ///< the visitor has stopped the flow
    step_failed      ///< no time step was small enough to close the curve and lower the energy
  };

  int step = 0;            ///< its number, from 1
  bool accepted = false;   ///< the curve has moved
  Stop stop = Stop::none;  ///< reason to stop after this step, if any

  double energy_before = 0, energy = 0;  ///< sum kappa^2 d, in 1/length
  double time_step = 0;                  ///< tau of the last trial
  int trials = 0;                        ///< number of time steps tried, each half of the previous
  double first_gap = 0;       ///< between the ends before they were joined, relative to the length
  double gap = 0;             ///< distributed over the edges: without exact closing, all of it
  int newton_iterations = 0;  ///< of exact closing
  double length_distortion = 0;  ///< maximal change of an edge, relative to its initial length
  int turning_number = 0;        ///< of a closed curve
};

/// \relates Curve_flow_report
/// Describes the reason
const char* to_string(Curve_step_report::Stop stop);

/// \ingroup PkgCurves
/// \brief Measurements of a whole curve flow.
struct [[nodiscard]] Curve_flow_report {
  Curve_step_report::Stop stop = Curve_step_report::Stop::none;
  std::vector<Curve_step_report> steps;  ///< the accepted ones
  double length = 0;                     ///< of the curve
  double initial_energy = 0, energy = 0;
  int turning_number = 0;        ///< of a closed curve, before and after
  double length_distortion = 0;  ///< from the first curve to the last one, maximum over the edges
  double seconds = 0;            ///< wall clock

  /// Returns whether the flow has converged
  bool converged() const { return stop == Curve_step_report::Stop::energy_settled; }

  /// Returns whether the flow has converged, or has done the requested steps
  explicit operator bool() const
  {
    return converged() || stop == Curve_step_report::Stop::steps_done;
  }
};

/// \relates Curve_flow_report
/// \brief Appends a step if it was accepted, and copies its reason to stop.
/// \returns whether the step was accepted
bool append(Curve_flow_report& report, const Curve_step_report& step);

/// \relates Curve_flow_report
/// Writes the numbers of a flow, one fact per line, and why it is not a success, if it is none
std::ostream& operator<<(std::ostream& out, const Curve_flow_report& r);

}  // namespace Conformal_geometry_processing
