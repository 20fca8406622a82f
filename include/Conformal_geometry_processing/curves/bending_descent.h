// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/curves/Polygon_lengths.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgCurves
/// \brief Computes the time derivative of the curvature of a polygon: the gradient flow of the
/// bending energy, -2 kappa, without components that would open a closed polygon [CGP 6.4.3].
///
/// For a closed polygon the result is orthogonal to 1, f^x and f^y with the dual lengths as
/// weights: sum d_i v_i = 0 and sum d_i v_i f_i = 0. O(m).
/// \param curvatures kappa, one per vertex \param points the vertices, 2 x m
/// \param direction receives m numbers
void bending_descent(const Eigen::VectorXd& curvatures, const internal::Plane_points& points,
                     const internal::Polygon_lengths& lengths, Eigen::VectorXd& direction);

}  // namespace Conformal_geometry_processing
