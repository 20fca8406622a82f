// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_CURVES_CLOSE_POLYGON_H
#define CONFORMAL_GEOMETRY_PROCESSING_CURVES_CLOSE_POLYGON_H

#include <Conformal_geometry_processing/curves/Closing_functions.h>
#include <Conformal_geometry_processing/curves/Polygon_lengths.h>
#include <Conformal_geometry_processing/curves/turning_number.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// how a polygon was closed
struct Closing_result {
  double first_gap = 0;  ///< between its ends before, by its length
  double gap = 0;        ///< the same afterwards
  int iterations = 0;    ///< of Newton's method
  bool is_closed = false;
};

namespace internal {

/// The gap of the edges, and the vertices: the first one where the last edge ends, as the
/// derivative of the gap wants it.
Eigen::Vector2d end_to_end(const Plane_points& tangents, Plane_points& points);

/// One step of Newton's method: the change of curvature, a combination of the functions at the
/// vertices of `shape`, that closes the gap and brings the total turning to `turning`, to first
/// order.
void correct_curvatures(const Eigen::Vector2d& gap, double turning, const Plane_points& points,
                        const Closing_functions& functions, const Plane_points& shape,
                        const Polygon_lengths& lengths, Eigen::VectorXd& curvatures);

}  // namespace internal

/// \ingroup PkgCurves
/// \brief changes curvatures by a combination of 1, f^x and f^y such that the polygon of given
/// lengths closes, with a given turning number: Newton's method for these three equations. O(m)
/// for each iteration, of which few are needed.
///
/// \param turning_number of the closed polygon \param angle of edge 0
/// \param shape the vertices f of a closed polygon not too different, 2 x m
/// \param curvatures one per vertex; closed afterwards, if the result says so
/// \param tangents receives its edges, 2 x m \param points is overwritten, 2 x m
/// \returns `is_closed` where the gap is below 1e-13 of the length
Closing_result close_polygon(const Polygon_lengths& lengths, int turning_number, double angle,
                             const Plane_points& shape, Eigen::VectorXd& curvatures,
                             Plane_points& tangents, Plane_points& points);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/curves/close_polygon_impl.h>
#endif

#endif
