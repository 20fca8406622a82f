// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/exceptions.h>

#include <Eigen/Core>

#include <string>

namespace Conformal_geometry_processing {

/// \ingroup PkgSurfaces
/// \brief Returns m equidistant points along a closed polygon in any space, including its first
/// vertex.
/// \param polygon d x k points
/// \param lengths k positive numbers, assigned to the edges from point i to the next
/// \throw Precondition_error if the lengths are not k positive finite numbers, or m is below one
template <int Dimension>
Eigen::Matrix<double, Dimension, Eigen::Dynamic> evenly_spaced(
    const Eigen::Matrix<double, Dimension, Eigen::Dynamic>& polygon, const Eigen::VectorXd& lengths,
    int m)
{
  const Eigen::Index k = polygon.cols();
  if (m < 1 || k < 1 || lengths.size() != k || !(lengths.array() > 0).all() || !lengths.allFinite())
    throw Precondition_error("evenly_spaced",
                             std::to_string(m) + " points on " + std::to_string(k) + " edges of " +
                                 std::to_string(lengths.size()) +
                                 " lengths; wanted one positive length for each edge");
  Eigen::Matrix<double, Dimension, Eigen::Dynamic> points(polygon.rows(), m);
  const double step = lengths.sum() / m;
  Eigen::Index edge = 0;
  double start = 0;  // of the edge
  for (int i = 0; i < m; ++i) {
    while (edge < k - 1 && start + lengths[edge] <= i * step) start += lengths[edge++];
    const double t = (i * step - start) / lengths[edge];
    points.col(i) = (1 - t) * polygon.col(edge) + t * polygon.col((edge + 1) % k);
  }
  return points;
}

}  // namespace Conformal_geometry_processing
