// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/curves/Isometric_curve_flow.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>

namespace Conformal_geometry_processing {

const char* to_string(Curve_step_report::Stop stop)
{
  switch (stop) {
    case Curve_step_report::Stop::none:
      return "not stopped";
    case Curve_step_report::Stop::energy_settled:
      return "the energy has settled";
    case Curve_step_report::Stop::steps_done:
      return "all steps are done";
    case Curve_step_report::Stop::cancelled:
      return "cancelled";
    case Curve_step_report::Stop::step_failed:
      return "the step failed";
  }
  return "unknown";
}

bool append(Curve_flow_report& report, const Curve_step_report& step)
{
  report.stop = step.stop;
  if (step.accepted) report.steps.push_back(step);
  return step.accepted;
}

std::ostream& operator<<(std::ostream& out, const Curve_flow_report& r)
{
  return out << "steps                  " << r.steps.size() << "; " << to_string(r.stop)
             << "\nbending energy         from " << r.initial_energy << " to " << r.energy
             << "\nlength                 " << r.length << ", of edges changed by "
             << r.length_distortion << " at most\nfault                  "
             << (r ? "none" : to_string(r.stop)) << '\n';
}

const Curve_flow_options& checked(const Curve_flow_options& o, const std::string& function)
{
  if (!(o.time_step > 0 && o.time_step < 1))
    throw Precondition_error(function, "a time step of " + std::to_string(o.time_step) +
                                           "; one between 0 and 1 is needed, where it is stable");
  if (o.max_steps < 0)
    throw Precondition_error(
        function, std::to_string(o.max_steps) + " steps; a number that is not negative is needed");
  if (!(o.energy_tolerance >= 0))
    throw Precondition_error(function, "a tolerance of " + std::to_string(o.energy_tolerance) +
                                           "; zero or a positive number is needed");
  return o;
}

Isometric_curve_flow::Isometric_curve_flow(const internal::Plane_points& points,
                                           const Curve_flow_options& options,
                                           const std::string& function)
    : m_function(function),
      m_options(checked(options, function)),
      m_frame(required(points, options.is_closed, function)),
      m_output(points),
      m_points(m_frame.to_frame(points)),
      m_new_points(m_points),
      m_lengths(m_points, options.is_closed),
      m_given_lengths(points, options.is_closed),
      m_curvatures(turning_angles(m_points, options.is_closed)),
      m_direction(points.cols()),
      m_new_curvatures(points.cols()),
      m_tangents(2, m_lengths.size_of_edges())
{
  m_turning_number = is_closed() ? turning_number(m_curvatures) : 0;
  m_curvatures.array() /= m_lengths.duals().array();
  m_initial_energy = m_energy = bending_energy(m_curvatures, m_lengths);
}

Curve_step_report Isometric_curve_flow::step()
{
  m_visits.require_no_visit(m_function);
  Curve_step_report report;
  report.step = m_steps + 1;
  report.turning_number = m_turning_number;
  report.energy_before = energy();
  bending_descent(m_curvatures, m_points, m_lengths, m_direction);
  report.time_step = 2 * m_options.time_step;
  while (!report.accepted && report.trials < max_trials) {
    report.time_step /= 2;
    ++report.trials;
    report.accepted = try_step(report);
  }
  report.stop = report.accepted ? accept(report) : Curve_step_report::Stop::step_failed;
  if (report.stop == Curve_step_report::Stop::energy_settled && is_saddle() && leave_saddle())
    report.stop = Curve_step_report::Stop::none;
  report.energy = energy();
  return report;
}

const internal::Plane_points& Isometric_curve_flow::required(const internal::Plane_points& points,
                                                             bool is_closed,
                                                             const std::string& function)
{
  require_polygon(points, is_closed, function);
  return points;
}

// Computes the next polygon in m_new_points and its curvatures in m_new_curvatures; returns false
// if it is not acceptable.
bool Isometric_curve_flow::try_step(Curve_step_report& report)
{
  m_new_curvatures = m_curvatures + report.time_step * m_direction;
  const Eigen::Vector2d first_edge = m_points.col(1) - m_points.col(0);
  if (!integrate(std::atan2(first_edge.y(), first_edge.x()), report)) return false;
  report.gap = integrate_tangents(m_tangents, m_lengths, m_new_points).norm() / m_lengths.total();
  if (report.newton_iterations == 0) report.first_gap = (std::max)(report.first_gap, report.gap);
  align(m_points, m_lengths.duals(), m_new_points);
  return has_same_turns() &&
         bending_energy(m_new_curvatures, m_lengths) <= m_energy + energy_noise * m_initial_energy;
}

bool Isometric_curve_flow::integrate(double angle, Curve_step_report& report)
{
  if (!is_closed() || m_options.closing == Curve_flow_options::Closing::least_squares) {
    integrate_curvature(m_new_curvatures, m_lengths, angle, m_tangents);
    return true;
  }
  const internal::Closing_result closing = close_polygon(
      m_lengths, m_turning_number, angle, m_points, m_new_curvatures, m_tangents, m_new_points);
  report.first_gap = closing.first_gap;
  report.newton_iterations = closing.iterations;
  return closing.is_closed;
}

// Returns whether all turning angles are less than pi. They change if lengths have changed.
bool Isometric_curve_flow::has_same_turns()
{
  const auto duals = m_lengths.duals().array();
  const double largest = two_pi / 2 - half_turn_tolerance;
  if (!is_closed() || m_options.closing == Curve_flow_options::Closing::exact)
    return (m_new_curvatures.array() * duals).abs().maxCoeff() < largest;
  turning_angles(m_new_points, is_closed(), m_new_curvatures);
  const bool same = turning_number(m_new_curvatures) == m_turning_number &&
                    m_new_curvatures.cwiseAbs().maxCoeff() < largest;
  m_new_curvatures.array() /= duals;
  return same;
}

Curve_step_report::Stop Isometric_curve_flow::accept(Curve_step_report& report)
{
  m_points.swap(m_new_points);
  m_curvatures.swap(m_new_curvatures);
  m_frame.from_frame(m_points, m_output);
  ++m_steps;
  const double before = m_energy;
  m_energy = bending_energy(m_curvatures, m_lengths);
  report.length_distortion = length_distortion(m_output, m_given_lengths);
  const double scale = (std::max)(m_energy, m_initial_energy / 100);
  const bool is_settled =
      std::abs(before - m_energy) <= m_options.energy_tolerance * report.time_step * scale;
  return is_settled ? Curve_step_report::Stop::energy_settled : Curve_step_report::Stop::none;
}

// The figure eight has 32 K(m)^2 (2 m - 1) with 2 E(m) = K(m); run through n times, n^2 of it.
bool Isometric_curve_flow::is_saddle() const
{
  const double least = 112.43961;
  return is_closed() && m_turning_number == 0 && m_energy * m_lengths.total() > 1.5 * least;
}

bool Isometric_curve_flow::leave_saddle()
{
  const internal::Plane_points points = m_points;
  const Eigen::VectorXd curvatures = m_curvatures;
  const double energy = m_energy;
  const int steps = m_steps;
  for (const double amplitude : {0.1, 0.03, 0.01}) {
    set_long_waves();
    const bool has_left = falls_below(energy, amplitude);
    m_steps = steps;
    if (has_left) return true;
    m_points = points;
    m_curvatures = curvatures;
    m_energy = energy;
    m_frame.from_frame(m_points, m_output);
  }
  return false;
}

bool Isometric_curve_flow::falls_below(double energy, double amplitude)
{
  const double gain = 1e-4, slight = 0.25;
  m_energy = std::numeric_limits<double>::infinity();  // the bent curve may have more
  for (int trial = 0; trial < max_saddle_steps; ++trial) {
    Curve_step_report report;
    report.time_step = trial == 0 ? amplitude : slight;
    if (!try_step(report)) return false;
    (void)accept(report);
    if (m_energy < (1 - gain) * energy) return true;
    bending_descent(m_curvatures, m_points, m_lengths, m_direction);
  }
  return false;
}

// Waves that are not symmetric to each other under any shift along the curve.
void Isometric_curve_flow::set_long_waves()
{
  const double size = std::sqrt(m_energy / m_lengths.total());
  double s = 0;
  for (Eigen::Index i = 0; i < m_direction.size(); ++i) {
    const double turn = two_pi * s / m_lengths.total();
    double wave = 0;
    for (int waves = 1; waves <= 5; ++waves) wave += std::cos(waves * turn + waves * waves);
    m_new_curvatures[i] = -size / 2 * wave;
    s += m_lengths.duals()[i];
  }
  bending_descent(m_new_curvatures, m_points, m_lengths, m_direction);
}

}  // namespace Conformal_geometry_processing
