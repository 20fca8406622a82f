// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/curves/Polygon_lengths.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgCurves
/// \brief Computes the turning angle at each vertex of a polygon: in (-pi, pi], positive to the
/// left. O(m).
///
/// The sum over a closed polygon is its turning number times 2 pi, up to rounding. If an edge
/// reverses its direction, the sign is arbitrary; `require_polygon()` rejects this case.
/// \param points the vertices, 2 x m, m > 2
/// \param angles receives m numbers, zero at the ends of an open polygon
void turning_angles(const internal::Plane_points& points, bool is_closed, Eigen::VectorXd& angles);

/// \relates turning_angles
Eigen::VectorXd turning_angles(const internal::Plane_points& points, bool is_closed);

}  // namespace Conformal_geometry_processing
