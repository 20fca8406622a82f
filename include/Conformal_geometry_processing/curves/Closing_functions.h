// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_CURVES_CLOSING_FUNCTIONS_H
#define CONFORMAL_GEOMETRY_PROCESSING_CURVES_CLOSING_FUNCTIONS_H

#include <Conformal_geometry_processing/curves/Polygon_lengths.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgCurves
/// \brief the functions 1, f^x, f^y on the vertices of a curve f, made orthogonal: a change of
/// curvature keeps the curve closed, to first order, where it has no share in them [CGP 4.2].
///
/// They are 1 and the coordinates along the principal axes of the curve, so they depend neither on
/// where it lies nor on where it begins. O(m).
class Closing_functions {
 public:
  /// \param points 2 x m \param weights of the inner product: the dual lengths, m positive numbers
  Closing_functions(const Plane_points& points, const Eigen::VectorXd& weights);

  /// the three functions at a point
  Eigen::Vector3d values(const Eigen::Vector2d& point) const;

  /// the function with these inner products with the three, as their linear combination
  Eigen::Vector3d combination(const Eigen::Vector3d& products) const;

 private:
  Eigen::Vector2d m_mean, m_axis;
  Eigen::Vector3d m_norms;  // squared
};

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/curves/Closing_functions_impl.h>
#endif

#endif
