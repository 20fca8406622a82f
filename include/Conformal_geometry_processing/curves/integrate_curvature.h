// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_CURVES_INTEGRATE_CURVATURE_H
#define CONFORMAL_GEOMETRY_PROCESSING_CURVES_INTEGRATE_CURVATURE_H

#include <Conformal_geometry_processing/curves/Polygon_lengths.h>

#include <Eigen/Core>

#include <cmath>

namespace Conformal_geometry_processing {

/// \ingroup PkgCurves
/// \brief the edges of the polygon that has these curvatures and lengths [CGP 6.4.3]:
/// T_i = l_i (cos theta_i, sin theta_i), theta_i = theta_{i-1} + d_i kappa_i. O(m).
///
/// Each has its length to rounding, but their sum need not be zero. The curvature at vertex 0 has
/// no say: it turns the last edge of a closed polygon into the first.
/// \param curvatures one per vertex \param angle of edge 0, theta_0
/// \param tangents receives an edge per column, 2 x number of edges
inline void integrate_curvature(const Eigen::VectorXd& curvatures, const Polygon_lengths& lengths,
                                double angle, Plane_points& tangents)
{
  tangents.resize(2, lengths.size_of_edges());
  for (Eigen::Index i = 0; i < lengths.size_of_edges(); ++i) {
    if (i > 0) angle += lengths.duals()[i] * curvatures[i];
    tangents(0, i) = lengths.edges()[i] * std::cos(angle);
    tangents(1, i) = lengths.edges()[i] * std::sin(angle);
  }
}

}  // namespace Conformal_geometry_processing

#endif
