// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/curves/Closing_functions.h>
#include <Conformal_geometry_processing/curves/Polygon_lengths.h>
#include <Conformal_geometry_processing/curves/turning_number.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

namespace internal {

/// Result of closing a polygon
struct Closing_result {
  double first_gap = 0;  ///< between its ends before, relative to its length
  double gap = 0;        ///< likewise, afterwards
  int iterations = 0;    ///< of Newton's method
  bool is_closed = false;
};

/// Returns the gap of the edges, and computes the vertices; the last edge ends at the first vertex,
/// as required by the derivative of the gap.
Eigen::Vector2d end_to_end(const Plane_points& tangents, Plane_points& points);

/// One step of Newton's method: changes the curvature by a combination of the functions at the
/// vertices of `shape`, such that to first order the gap is closed and the total turning is
/// `turning`.
void correct_curvatures(const Eigen::Vector2d& gap, double turning, const Plane_points& points,
                        const Closing_functions& functions, const Plane_points& shape,
                        const Polygon_lengths& lengths, Eigen::VectorXd& curvatures);

}  // namespace internal

/// \ingroup PkgCurves
/// \brief Changes curvatures by a combination of 1, f^x and f^y such that the polygon with given
/// lengths closes, with a given turning number: Newton's method for these three equations. O(m)
/// per iteration; few iterations are needed.
///
/// \param turning_number of the closed polygon \param angle of edge 0
/// \param shape the vertices f of a similar closed polygon, 2 x m
/// \param curvatures one per vertex; they close the polygon afterwards, if the result says so
/// \param tangents receives its edges, 2 x m \param points is overwritten, 2 x m
/// \returns `is_closed` if the gap is below 1e-13 of the length
internal::Closing_result close_polygon(const internal::Polygon_lengths& lengths, int turning_number,
                                       double angle, const internal::Plane_points& shape,
                                       Eigen::VectorXd& curvatures,
                                       internal::Plane_points& tangents,
                                       internal::Plane_points& points);

}  // namespace Conformal_geometry_processing
