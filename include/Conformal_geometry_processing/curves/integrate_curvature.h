// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/curves/Polygon_lengths.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgCurves
/// \brief Computes the edges of the polygon with these curvatures and lengths [CGP 6.4.3]:
/// T_i = l_i (cos theta_i, sin theta_i), theta_i = theta_{i-1} + d_i kappa_i. O(m).
///
/// Lengths are exact up to rounding, but the sum of the edges need not be zero. The curvature at
/// vertex 0 is not used: it turns the last edge of a closed polygon into the first.
/// \param curvatures one per vertex \param angle of edge 0, theta_0
/// \param tangents receives an edge per column, 2 x number of edges
void integrate_curvature(const Eigen::VectorXd& curvatures,
                         const internal::Polygon_lengths& lengths, double angle,
                         internal::Plane_points& tangents);

}  // namespace Conformal_geometry_processing
