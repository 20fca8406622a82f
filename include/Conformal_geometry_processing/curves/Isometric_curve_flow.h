// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_CURVES_ISOMETRIC_CURVE_FLOW_H
#define CONFORMAL_GEOMETRY_PROCESSING_CURVES_ISOMETRIC_CURVE_FLOW_H

#include <Conformal_geometry_processing/curves/Curve_flow_options.h>
#include <Conformal_geometry_processing/curves/Curve_flow_report.h>
#include <Conformal_geometry_processing/curves/Curve_flow_visitor.h>
#include <Conformal_geometry_processing/curves/Curve_frame.h>
#include <Conformal_geometry_processing/curves/Polygon_lengths.h>
#include <Conformal_geometry_processing/curves/turning_number.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Stopwatch.h>

#include <Eigen/Core>

#include <string>

namespace Conformal_geometry_processing {

/// \ingroup PkgCurves
/// \brief makes a polygon in the plane as little bent as its turning number allows, step by step,
/// without stretching any of its edges [CGP 4.2, 6.4.3].
///
/// The curvature moves along `bending_descent()`; integrating it twice gives the polygon of
/// the lengths that the first one had, whatever the number of steps. The centroid stays, and
/// each curve is turned as near as possible to the one before. A step that would not close up,
/// change the turning number or raise the energy is tried again with half of tau. O(m) time for a
/// step, which takes no memory.
class Isometric_curve_flow {
 public:
  /// \param points the vertices, 2 x m \param function is named by what is thrown
  /// \throw Precondition_error if the points do not fulfil `require_polygon()`, or an option is out
  /// of its range
  explicit Isometric_curve_flow(const Plane_points& points, const Curve_flow_options& options = {},
                                const std::string& function = "Isometric_curve_flow");

  bool is_closed() const { return m_options.is_closed; }

  /// the vertices of the present polygon
  const Plane_points& points() const { return m_output; }

  /// its bending energy, in 1/length
  double energy() const { return m_energy / m_frame.unit(); }

  /// its length, which stays
  double length() const { return m_lengths.total() * m_frame.unit(); }

  /// how often a closed one turns, which stays
  int turning_number_of_curve() const { return m_turning_number; }

  /// One step. If it fails, the polygon stays as it is, and the report says so.
  Curve_step_report step();

  /// Steps until there is a reason to stop. \param visitor a model of `CurveFlowVisitor`
  template <class Visitor>
  Curve_flow_report run(Visitor& visitor)
  {
    Stopwatch watch;
    Curve_flow_report report;
    report.length = length();
    report.turning_number = m_turning_number;
    report.initial_energy = energy();
    visitor.on_flow_begin(m_output, energy());
    for (int i = 0; report.stop == Curve_flow_stop::none; ++i) {
      if (i == m_options.max_steps)
        report.stop = Curve_flow_stop::steps_done;
      else if (!visitor.go_further())
        report.stop = Curve_flow_stop::cancelled;
      else if (append(report, step()))
        visitor.on_step_end(report.steps.back(), m_output);
    }
    report.energy = energy();
    report.length_distortion = length_distortion(m_points, m_lengths);
    report.seconds = watch.lap();
    return report;
  }

 private:
  static constexpr int max_trials = 12;
  static constexpr double energy_noise = 1e-11;  // of the first energy

  static const Plane_points& required(const Plane_points& points, bool is_closed,
                                      const std::string& function);
  bool try_step(Curve_step_report& report);
  bool integrate(double angle, Curve_step_report& report);
  bool has_same_turns();
  Curve_flow_stop accept(Curve_step_report& report);

  Curve_flow_options m_options;
  Curve_frame m_frame;
  Plane_points m_output;                // in the units of the curve
  Plane_points m_points, m_new_points;  // in the frame, as is all that follows
  Polygon_lengths m_lengths;
  Eigen::VectorXd m_curvatures, m_direction, m_new_curvatures;
  Plane_points m_tangents;
  int m_turning_number = 0, m_steps = 0;
  double m_initial_energy = 0, m_energy = 0;
};

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/curves/Isometric_curve_flow_impl.h>
#endif

#endif
