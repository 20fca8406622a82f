// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/curves/bending_descent.h>

#include <Conformal_geometry_processing/curves/Closing_functions.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

void bending_descent(const Eigen::VectorXd& curvatures, const internal::Plane_points& points,
                     const internal::Polygon_lengths& lengths, Eigen::VectorXd& direction)
{
  direction = -2 * curvatures;
  if (!lengths.is_closed()) return;
  const internal::Closing_functions functions(points, lengths.duals());
  Eigen::Vector3d products = Eigen::Vector3d::Zero();
  for (Eigen::Index i = 0; i < direction.size(); ++i)
    products += lengths.duals()[i] * direction[i] * functions.values(points.col(i));
  const Eigen::Vector3d share = functions.combination(products);
  for (Eigen::Index i = 0; i < direction.size(); ++i)
    direction[i] -= share.dot(functions.values(points.col(i)));
}

}  // namespace Conformal_geometry_processing
