// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/curves/curve_requirements.h>

#include <Conformal_geometry_processing/curves/Curve_frame.h>
#include <Conformal_geometry_processing/curves/turning_angles.h>
#include <Conformal_geometry_processing/curves/turning_number.h>
#include <Conformal_geometry_processing/mesh/requirements.h>

#include <Eigen/Core>

#include <cmath>
#include <string>

namespace Conformal_geometry_processing {
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
