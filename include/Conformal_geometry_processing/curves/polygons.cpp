// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/curves/polygons.h>

#include <Conformal_geometry_processing/mesh/requirements.h>

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

}  // namespace Conformal_geometry_processing
