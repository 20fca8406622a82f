// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_CURVES_ISOMETRIC_CURVE_FLOW_H
#define CONFORMAL_GEOMETRY_PROCESSING_CURVES_ISOMETRIC_CURVE_FLOW_H

#include <Conformal_geometry_processing/curves/Curve_flow_options.h>
#include <Conformal_geometry_processing/curves/Curve_flow_report.h>
#include <Conformal_geometry_processing/curves/Curve_flow_visitor.h>
#include <Conformal_geometry_processing/curves/Curve_frame.h>
#include <Conformal_geometry_processing/curves/Polygon_lengths.h>
#include <Conformal_geometry_processing/curves/bending_energy.h>
#include <Conformal_geometry_processing/curves/close_polygon.h>
#include <Conformal_geometry_processing/curves/constrained_direction.h>
#include <Conformal_geometry_processing/curves/curve_alignment.h>
#include <Conformal_geometry_processing/curves/curve_requirements.h>
#include <Conformal_geometry_processing/curves/integrate_curvature.h>
#include <Conformal_geometry_processing/curves/integrate_tangents.h>
#include <Conformal_geometry_processing/curves/turning_angles.h>
#include <Conformal_geometry_processing/curves/turning_number.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Stopwatch.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <string>

namespace Conformal_geometry_processing {

/// \ingroup PkgCurves
/// \brief makes a polygon in the plane as little bent as its turning number allows, step by step,
/// without stretching any of its edges [CGP 4.2, 6.4.3].
///
/// The curvature moves along `constrained_direction()`; integrating it twice gives the polygon of
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
                                const std::string& function = "Isometric_curve_flow")
      : m_options(checked(options, function)),
        m_frame(required(points, options.is_closed, function)),
        m_output(points),
        m_points(m_frame.to_frame(points)),
        m_new_points(m_points),
        m_lengths(m_points, options.is_closed),
        m_curvatures(turning_angles(m_points, options.is_closed)),
        m_direction(points.cols()),
        m_new_curvatures(points.cols()),
        m_tangents(2, m_lengths.size_of_edges())
  {
    m_turning_number = is_closed() ? turning_number(m_curvatures) : 0;
    m_curvatures.array() /= m_lengths.duals().array();
    m_initial_energy = m_energy = bending_energy(m_curvatures, m_lengths);
  }

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
  Curve_step_report step()
  {
    Curve_step_report report;
    report.step = m_steps + 1;
    report.turning_number = m_turning_number;
    report.energy_before = energy();
    constrained_direction(m_curvatures, m_points, m_lengths, m_direction);
    report.time_step = 2 * m_options.time_step;
    while (!report.accepted && report.trials < max_trials) {
      report.time_step /= 2;
      ++report.trials;
      report.accepted = try_step(report);
    }
    report.stop = report.accepted ? accept(report) : Curve_flow_stop::step_failed;
    report.energy = energy();
    return report;
  }

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
                                      const std::string& function)
  {
    require_polygon(points, is_closed, function);
    return points;
  }

  // Puts the next polygon into m_new_points and its curvatures into m_new_curvatures; false where
  // it will not do.
  bool try_step(Curve_step_report& report)
  {
    m_new_curvatures = m_curvatures + report.time_step * m_direction;
    const Eigen::Vector2d first_edge = m_points.col(1) - m_points.col(0);
    if (!integrate(std::atan2(first_edge.y(), first_edge.x()), report)) return false;
    report.gap = integrate_tangents(m_tangents, m_lengths, m_new_points).norm() / m_lengths.total();
    if (report.newton_iterations == 0) report.first_gap = (std::max)(report.first_gap, report.gap);
    align(m_points, m_lengths.duals(), m_new_points);
    return has_same_turns() && bending_energy(m_new_curvatures, m_lengths) <=
                                   m_energy + energy_noise * m_initial_energy;
  }

  bool integrate(double angle, Curve_step_report& report)
  {
    if (!is_closed() || m_options.closing == Curve_closing::least_squares) {
      integrate_curvature(m_new_curvatures, m_lengths, angle, m_tangents);
      return true;
    }
    const Closing_result closing = close_polygon(m_lengths, m_turning_number, angle, m_points,
                                                 m_new_curvatures, m_tangents, m_new_points);
    report.first_gap = closing.first_gap;
    report.newton_iterations = closing.iterations;
    return closing.is_closed;
  }

  // Whether no vertex turns by pi or more. Where lengths have changed, so have the angles.
  bool has_same_turns()
  {
    const auto duals = m_lengths.duals().array();
    const double largest = two_pi / 2 - half_turn_tolerance;
    if (!is_closed() || m_options.closing == Curve_closing::exact)
      return (m_new_curvatures.array() * duals).abs().maxCoeff() < largest;
    turning_angles(m_new_points, is_closed(), m_new_curvatures);
    const bool same = turning_number(m_new_curvatures) == m_turning_number &&
                      m_new_curvatures.cwiseAbs().maxCoeff() < largest;
    m_new_curvatures.array() /= duals;
    return same;
  }

  Curve_flow_stop accept(Curve_step_report& report)
  {
    m_points.swap(m_new_points);
    m_curvatures.swap(m_new_curvatures);
    m_frame.from_frame(m_points, m_output);
    ++m_steps;
    const double before = m_energy;
    m_energy = bending_energy(m_curvatures, m_lengths);
    report.length_distortion = length_distortion(m_points, m_lengths);
    const double scale = (std::max)(m_energy, m_initial_energy / 100);
    const bool is_settled =
        std::abs(before - m_energy) <= m_options.energy_tolerance * report.time_step * scale;
    return is_settled ? Curve_flow_stop::energy_settled : Curve_flow_stop::none;
  }

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

#endif
