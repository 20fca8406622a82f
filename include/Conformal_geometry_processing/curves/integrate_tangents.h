// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/curves/Polygon_lengths.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgCurves
/// \brief Computes the polygon whose edges are closest to given ones: it minimizes
/// sum |f_{i+1} - f_i - T_i|^2 / l_i [CGP 6.4.3].
///
/// For a closed polygon this is the solution of the Poisson equation L f = b, where L is cyclic
/// and tridiagonal with -1/l_i off its diagonal, and b_i = T_{i-1}/l_{i-1} - T_i/l_i (the thesis
/// has b with the opposite sign, which gives -f). In the unknowns q_i = (f_{i+1} - f_i)/l_i it
/// reads q_i - q_{i-1} = T_i/l_i - T_{i-1}/l_{i-1}: the q_i equal T_i/l_i up to a constant, which
/// is determined by the closing condition. Each edge therefore takes a share of the gap in
/// proportion to its length. Two passes solve the equation in O(m), without the cancellation of an
/// elimination, whose matrix has a condition number of order m^2. Every vertex is accurate to one
/// rounding of its coordinates.
///
/// \param tangents an edge per column \param points receives the vertices, the first one at 0
/// \returns the sum of the edges of a closed polygon: the gap that was distributed
Eigen::Vector2d integrate_tangents(const internal::Plane_points& tangents,
                                   const internal::Polygon_lengths& lengths,
                                   internal::Plane_points& points);

}  // namespace Conformal_geometry_processing
