// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/curves/Polygon_lengths.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgCurves
/// \brief Aligns a curve to another one by the rigid motion that matches the centroids and
/// minimizes the weighted sum of squared distances.
///
/// Curvature determines a curve up to a rigid motion only; this choice depends neither on the
/// numbering of the vertices nor on the origin of the plane. If all rotations are equally good, the
/// curve is not rotated. O(m).
/// \param to 2 x m \param weights of the vertices, m numbers \param points are moved, 2 x m
/// \returns the angle of the rotation, counterclockwise
double align(const internal::Plane_points& to, const Eigen::VectorXd& weights,
             internal::Plane_points& points);

}  // namespace Conformal_geometry_processing
