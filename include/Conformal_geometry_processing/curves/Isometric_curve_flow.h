// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/curves/polygons.h>
#include <Quaternionic_linear_algebra/direct/Stopwatch.h>
#include <Quaternionic_linear_algebra/exceptions.h>
#include <Quaternionic_linear_algebra/krylov/Visit_guard.h>

#include <Eigen/Core>

#include <iosfwd>
#include <string>
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

/// \ingroup PkgCurves
/// \brief Minimizes the bending energy of a polygon in the plane within its turning number, step by
/// step, without stretching its edges [CGP 4.2, 6.4.3].
///
/// The curvature moves along `bending_descent()`; integrating it twice gives a polygon with the
/// edge lengths of the first one, for any number of steps. The centroid is fixed, and each curve is
/// rotated to match the previous one as well as possible. A step that fails to close, changes the
/// turning number or raises the energy is repeated with half of tau. O(m) time per step, without
/// allocations.
///
/// The least energy is that of the k-fold circle, or of the figure eight if the turning number k is
/// zero. A figure eight that is run through several times is critical, too, but a saddle: where the
/// flow settles at one, the curve is bent along long waves, and goes on if it finds less energy.
class Isometric_curve_flow {
 public:
  /// \param points the vertices, 2 x m \param function named in exceptions
  /// \throw Precondition_error if the points violate `require_polygon()`, or an option is out of
  /// its range
  explicit Isometric_curve_flow(const internal::Plane_points& points,
                                const Curve_flow_options& options = {},
                                const std::string& function = "Isometric_curve_flow");

  bool is_closed() const { return m_options.is_closed; }

  /// The vertices of the current polygon
  const internal::Plane_points& points() const { return m_output; }

  /// Its bending energy, in 1/length
  double energy() const { return m_energy / m_frame.unit(); }

  /// Its length, which is constant
  double length() const { return m_lengths.total() * m_frame.unit(); }

  /// Its turning number if it is closed, which is constant
  int turning_number_of_curve() const { return m_turning_number; }

  /// \brief Takes one step. If it fails, the polygon is unchanged, and the report says so.
  /// \throw Precondition_error if it is called by the visitor of `run()`
  Curve_step_report step();

  /// \brief Takes steps until there is a reason to stop.
  /// \param visitor a model of `CurveFlowVisitor`
  /// \throw Precondition_error if the visitor calls `step()` or `run()`
  template <class Visitor>
  Curve_flow_report run(Visitor& visitor)
  {
    m_visits.require_no_visit(m_function);
    internal::Stopwatch watch;
    Curve_flow_report report;
    report.length = length();
    report.turning_number = m_turning_number;
    report.initial_energy = energy();
    m_visits.during([&] { visitor.on_flow_begin(m_output, energy()); });
    for (int i = 0; report.stop == Curve_step_report::Stop::none; ++i) {
      if (i == m_options.max_steps)
        report.stop = Curve_step_report::Stop::steps_done;
      else if (!m_visits.during([&] { return visitor.go_further(); }))
        report.stop = Curve_step_report::Stop::cancelled;
      else if (append(report, step()))
        m_visits.during([&] { visitor.on_step_end(report.steps.back(), m_output); });
    }
    report.energy = energy();
    report.length_distortion = length_distortion(m_output, m_given_lengths);
    report.seconds = watch.lap();
    return report;
  }

 private:
  static constexpr int max_trials = 12;
  static constexpr int max_saddle_steps = 50;    // eights run twice need three
  static constexpr double energy_noise = 1e-11;  // relative to the initial energy

  static const internal::Plane_points& required(const internal::Plane_points& points,
                                                bool is_closed, const std::string& function);
  bool try_step(Curve_step_report& report);
  bool integrate(double angle, Curve_step_report& report);
  bool has_same_turns();
  Curve_step_report::Stop accept(Curve_step_report& report);

  /// whether the curve is far above the least energy of its turning number, zero
  bool is_saddle() const;

  /// bends the curve along long waves and lets it flow until its energy is lower than now; returns
  /// false, with the curve unchanged, if it does not become so
  bool leave_saddle();

  /// goes the amplitude along m_direction and then down, and returns whether the energy falls below
  bool falls_below(double energy, double amplitude);

  /// makes m_direction a sum of long waves of curvature that keeps the curve closed to first order
  void set_long_waves();

  std::string m_function;
  internal::Visit_guard m_visits;
  Curve_flow_options m_options;
  internal::Curve_frame m_frame;
  internal::Plane_points m_output;                // in units of the curve
  internal::Plane_points m_points, m_new_points;  // in the frame, like all following members
  internal::Polygon_lengths m_lengths;
  internal::Polygon_lengths m_given_lengths;  // in units of the curve, of what was read
  Eigen::VectorXd m_curvatures, m_direction, m_new_curvatures;
  internal::Plane_points m_tangents;
  int m_turning_number = 0, m_steps = 0;
  double m_initial_energy = 0, m_energy = 0;
};

}  // namespace Conformal_geometry_processing
