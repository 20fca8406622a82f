// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/curves/Polygon_lengths.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgCurves
/// \brief The functions 1, f^x, f^y on the vertices of a curve f, orthogonalized: a change of
/// curvature that is orthogonal to them keeps the curve closed, to first order [CGP 4.2].
///
/// They are 1 and the coordinates along the principal axes of the curve, so they depend neither on
/// its position nor on its first vertex. O(m).
class Closing_functions {
 public:
  /// \param points 2 x m \param weights of the inner product: the dual lengths, m positive numbers
  Closing_functions(const Plane_points& points, const Eigen::VectorXd& weights);

  /// Returns the three functions at a point
  Eigen::Vector3d values(const Eigen::Vector2d& point) const;

  /// Returns the linear combination of the three functions that has these inner products with them
  Eigen::Vector3d combination(const Eigen::Vector3d& products) const;

 private:
  Eigen::Vector2d m_mean, m_axis;
  Eigen::Vector3d m_norms;  // squared
};

}  // namespace Conformal_geometry_processing::internal
