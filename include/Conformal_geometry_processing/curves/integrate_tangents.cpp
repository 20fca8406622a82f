// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/curves/integrate_tangents.h>

#include <Conformal_geometry_processing/curves/Compensated_sum.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

Eigen::Vector2d integrate_tangents(const internal::Plane_points& tangents,
                                   const internal::Polygon_lengths& lengths,
                                   internal::Plane_points& points)
{
  internal::Compensated_sum sum;
  if (lengths.is_closed())
    for (Eigen::Index i = 0; i < tangents.cols(); ++i) sum.add(tangents.col(i));
  const Eigen::Vector2d gap = sum.value();
  const Eigen::Vector2d share = gap / lengths.total();
  const Eigen::Index m = lengths.size_of_vertices();
  points.resize(2, m);
  points.col(0).setZero();
  internal::Compensated_sum point;
  for (Eigen::Index i = 0; i + 1 < m; ++i) {
    point.add(tangents.col(i) - lengths.edges()[i] * share);
    points.col(i + 1) = point.value();
  }
  return gap;
}

}  // namespace Conformal_geometry_processing
