// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/curves/polygons.h>

#include <Conformal_geometry_processing/mesh/requirements.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace Conformal_geometry_processing {

internal::Polygon_lengths::Polygon_lengths(const internal::Plane_points& points, bool is_closed)
    : m_edges(points.cols() - (is_closed ? 0 : 1)),
      m_duals(Eigen::VectorXd::Zero(points.cols())),
      m_is_closed(is_closed)
{
  const Eigen::Index m = points.cols();
  for (Eigen::Index i = 0; i < m_edges.size(); ++i) {
    const Eigen::Index next = i + 1 < m ? i + 1 : 0;
    m_edges[i] = (points.col(next) - points.col(i)).stableNorm();
    m_duals[i] += m_edges[i] / 2;
    m_duals[next] += m_edges[i] / 2;
  }
  m_total = m_edges.sum();
}

double length_distortion(const internal::Plane_points& points,
                         const internal::Polygon_lengths& original)
{
  double worst = 0;
  for (Eigen::Index i = 0; i < original.size_of_edges(); ++i) {
    const Eigen::Index next = i + 1 < points.cols() ? i + 1 : 0;
    const double length = (points.col(next) - points.col(i)).stableNorm();
    worst = (std::max)(worst, std::abs(length / original.edges()[i] - 1));
  }
  return worst;
}

void turning_angles(const internal::Plane_points& points, bool is_closed, Eigen::VectorXd& angles)
{
  const Eigen::Index m = points.cols();
  angles.resize(m);
  Eigen::Vector2d before = points.col(0) - points.col(m - 1);
  for (Eigen::Index i = 0; i < m; ++i) {
    const Eigen::Vector2d after = points.col(i + 1 < m ? i + 1 : 0) - points.col(i);
    const double cross = before.x() * after.y() - before.y() * after.x();
    angles[i] = std::atan2(cross, before.dot(after));
    before = after;
  }
  if (!is_closed) angles[0] = angles[m - 1] = 0;
}

Eigen::VectorXd turning_angles(const internal::Plane_points& points, bool is_closed)
{
  Eigen::VectorXd angles;
  turning_angles(points, is_closed, angles);
  return angles;
}

int turning_number(const Eigen::VectorXd& angles)
{
  return static_cast<int>(std::lround(angles.sum() / two_pi));
}

double bending_energy(const Eigen::VectorXd& curvatures, const internal::Polygon_lengths& lengths)
{
  return (curvatures.array().square() * lengths.duals().array()).sum();
}

internal::Plane_points internal::Curve_frame::to_frame(const internal::Plane_points& points) const
{
  return m_frame.to_frame(in_space(points)).topRows(2);
}

void internal::Curve_frame::from_frame(const internal::Plane_points& points,
                                       internal::Plane_points& result) const
{
  result = (unit() * points).colwise() + m_frame.center().head<2>();
}

Points internal::Curve_frame::in_space(const internal::Plane_points& points)
{
  Points p = Points::Zero(3, points.cols());
  p.topRows(2) = points;
  return p;
}

namespace internal {

void require_edges(const Plane_points& points, bool is_closed, const std::string& function)
{
  const Polygon_lengths lengths(points, is_closed);
  const int m = static_cast<int>(points.cols());
  const bool repeats_first = is_closed && points.col(0) == points.col(m - 1);
  refuse_if_any(
      static_cast<int>(lengths.size_of_edges()),
      [&](int i) { return !(lengths.edges()[i] > relative_length_tolerance * lengths.total()); },
      [&](int i) { return "points " + std::to_string(i) + " and " + std::to_string((i + 1) % m); },
      function, "#pair of points that follow each other and coincide",
      repeats_first ? "leave out the last point, which repeats the first" : "remove one of each");
}

void require_turns(const Plane_points& points, bool is_closed, const std::string& function)
{
  const Eigen::VectorXd angles = turning_angles(points, is_closed);
  refuse_if_any(
      static_cast<int>(points.cols()),
      [&](int i) { return !(std::abs(angles[i]) < two_pi / 2 - half_turn_tolerance); },
      [](int i) { return "point " + std::to_string(i); }, function,
      "#point where the curve goes straight back (a turn by +-pi)",
      "whether it turns to the left or to the right must be clear");
}

}  // namespace internal

void require_polygon(const internal::Plane_points& points, bool is_closed,
                     const std::string& function)
{
  if (points.cols() < 3)
    throw Precondition_error(function,
                             internal::counted(static_cast<int>(points.cols()), "#point") +
                                 "; a curve of three at least is needed");
  internal::refuse_if_any(
      static_cast<int>(points.cols()), [&](int i) { return !points.col(i).allFinite(); },
      [](int i) { return "point " + std::to_string(i); }, function,
      "#point with a coordinate that is not finite", "finite coordinates are needed");
  const internal::Plane_points in_frame = internal::Curve_frame(points).to_frame(points);
  internal::require_edges(in_frame, is_closed, function);
  internal::require_turns(in_frame, is_closed, function);
}

internal::Closing_functions::Closing_functions(const internal::Plane_points& points,
                                               const Eigen::VectorXd& weights)
{
  const double total = weights.sum();
  m_mean = points * weights / total;
  double xx = 0, xy = 0, yy = 0;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Vector2d p = points.col(i) - m_mean;
    xx += weights[i] * p.x() * p.x();
    xy += weights[i] * p.x() * p.y();
    yy += weights[i] * p.y() * p.y();
  }
  const double angle = std::atan2(2 * xy, xx - yy) / 2;
  m_axis = {std::cos(angle), std::sin(angle)};
  // Not from these sums, which lose all digits for the short axis of a thin curve.
  m_norms = Eigen::Vector3d::Zero();
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    m_norms += weights[i] * values(points.col(i)).cwiseAbs2();
}

Eigen::Vector3d internal::Closing_functions::values(const Eigen::Vector2d& point) const
{
  const Eigen::Vector2d p = point - m_mean;
  return {1, m_axis.x() * p.x() + m_axis.y() * p.y(), m_axis.x() * p.y() - m_axis.y() * p.x()};
}

Eigen::Vector3d internal::Closing_functions::combination(const Eigen::Vector3d& products) const
{
  Eigen::Vector3d c;
  for (int k = 0; k < 3; ++k) c[k] = m_norms[k] > 0 ? products[k] / m_norms[k] : 0;
  return c;
}

void internal::Compensated_sum::add(const Eigen::Vector2d& x)
{
  const Eigen::Vector2d sum = m_sum + x;
  const Eigen::Vector2d added = sum - m_sum;
  m_lost += (m_sum - (sum - added)) + (x - added);
  m_sum = sum;
}

Eigen::Vector2d integrate_tangents(const internal::Plane_points& tangents,
                                   const internal::Polygon_lengths& lengths,
                                   internal::Plane_points& points)
{
  internal::Compensated_sum sum;
  if (lengths.is_closed())
    for (Eigen::Index i = 0; i < tangents.cols(); ++i) sum.add(tangents.col(i));
  const Eigen::Vector2d gap = sum.value();
  const Eigen::Vector2d share = gap / lengths.total();
  const Eigen::Index m = lengths.size_of_vertices();
  points.resize(2, m);
  points.col(0).setZero();
  internal::Compensated_sum point;
  for (Eigen::Index i = 0; i + 1 < m; ++i) {
    point.add(tangents.col(i) - lengths.edges()[i] * share);
    points.col(i + 1) = point.value();
  }
  return gap;
}

void integrate_curvature(const Eigen::VectorXd& curvatures,
                         const internal::Polygon_lengths& lengths, double angle,
                         internal::Plane_points& tangents)
{
  tangents.resize(2, lengths.size_of_edges());
  for (Eigen::Index i = 0; i < lengths.size_of_edges(); ++i) {
    if (i > 0) angle += lengths.duals()[i] * curvatures[i];
    tangents(0, i) = lengths.edges()[i] * std::cos(angle);
    tangents(1, i) = lengths.edges()[i] * std::sin(angle);
  }
}

namespace internal {

Eigen::Vector2d end_to_end(const Plane_points& tangents, Plane_points& points)
{
  Eigen::Vector2d p = tangents.col(0);
  for (Eigen::Index i = 1; i < tangents.cols(); ++i) {
    points.col(i) = p;
    p += tangents.col(i);
  }
  points.col(0) = p;
  return p;
}

void correct_curvatures(const Eigen::Vector2d& gap, double turning, const Plane_points& points,
                        const Closing_functions& functions, const Plane_points& shape,
                        const Polygon_lengths& lengths, Eigen::VectorXd& curvatures)
{
  // Turning at vertex i by d_i k_i rotates the end p about f_i: the gap changes by
  // J (p - f_i) d_i k_i. The change is therefore determined by the moments d_i k_i (1, f_i); p,
  // whose distance from 0 is the gap, contributes to second order only.
  const Eigen::VectorXd& d = lengths.duals();
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (Eigen::Index i = 0; i < d.size(); ++i)
    moments += d[i] * Eigen::Vector3d(1, points(0, i), points(1, i)) *
               functions.values(shape.col(i)).transpose();
  const Eigen::Vector3d wanted(turning - d.dot(curvatures), gap.y(), -gap.x());
  const Eigen::Vector3d share = moments.fullPivLu().solve(wanted);
  for (Eigen::Index i = 0; i < d.size(); ++i)
    curvatures[i] += share.dot(functions.values(shape.col(i)));
}

}  // namespace internal

internal::Closing_result close_polygon(const internal::Polygon_lengths& lengths, int turning_number,
                                       double angle, const internal::Plane_points& shape,
                                       Eigen::VectorXd& curvatures,
                                       internal::Plane_points& tangents,
                                       internal::Plane_points& points)
{
  constexpr int max_iterations = 20;
  constexpr double tolerance = 1e-13;
  const double turning = turning_number * two_pi;
  const internal::Closing_functions functions(shape, lengths.duals());
  points.resize(2, lengths.size_of_vertices());
  internal::Closing_result result;
  for (; result.iterations <= max_iterations; ++result.iterations) {
    integrate_curvature(curvatures, lengths, angle, tangents);
    const Eigen::Vector2d gap = internal::end_to_end(tangents, points);
    const double excess = std::abs(lengths.duals().dot(curvatures) - turning);
    result.gap = gap.norm() / lengths.total();
    if (result.iterations == 0) result.first_gap = result.gap;
    result.is_closed = result.gap <= tolerance && excess <= tolerance * two_pi;
    if (result.is_closed || !std::isfinite(result.gap)) break;
    internal::correct_curvatures(gap, turning, points, functions, shape, lengths, curvatures);
  }
  return result;
}

double align(const internal::Plane_points& to, const Eigen::VectorXd& weights,
             internal::Plane_points& points)
{
  const double total = weights.sum();
  const Eigen::Vector2d from_mean = points * weights / total, to_mean = to * weights / total;
  double cosine = 0, sine = 0;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Vector2d p = points.col(i) - from_mean, q = to.col(i) - to_mean;
    cosine += weights[i] * p.dot(q);
    sine += weights[i] * (p.x() * q.y() - p.y() * q.x());
  }
  const double angle = std::atan2(sine, cosine);
  const double c = std::cos(angle), s = std::sin(angle);
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Vector2d p = points.col(i) - from_mean;
    points.col(i) = Eigen::Vector2d(c * p.x() - s * p.y(), s * p.x() + c * p.y()) + to_mean;
  }
  return angle;
}

void bending_descent(const Eigen::VectorXd& curvatures, const internal::Plane_points& points,
                     const internal::Polygon_lengths& lengths, Eigen::VectorXd& direction)
{
  direction = -2 * curvatures;
  if (!lengths.is_closed()) return;
  const internal::Closing_functions functions(points, lengths.duals());
  Eigen::Vector3d products = Eigen::Vector3d::Zero();
  for (Eigen::Index i = 0; i < direction.size(); ++i)
    products += lengths.duals()[i] * direction[i] * functions.values(points.col(i));
  const Eigen::Vector3d share = functions.combination(products);
  for (Eigen::Index i = 0; i < direction.size(); ++i)
    direction[i] -= share.dot(functions.values(points.col(i)));
}

}  // namespace Conformal_geometry_processing
