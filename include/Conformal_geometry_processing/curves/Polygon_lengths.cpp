// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/curves/Polygon_lengths.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace Conformal_geometry_processing {

internal::Polygon_lengths::Polygon_lengths(const internal::Plane_points& points, bool is_closed)
    : m_edges(points.cols() - (is_closed ? 0 : 1)),
      m_duals(Eigen::VectorXd::Zero(points.cols())),
      m_is_closed(is_closed)
{
  const Eigen::Index m = points.cols();
  for (Eigen::Index i = 0; i < m_edges.size(); ++i) {
    const Eigen::Index next = i + 1 < m ? i + 1 : 0;
    m_edges[i] = (points.col(next) - points.col(i)).stableNorm();
    m_duals[i] += m_edges[i] / 2;
    m_duals[next] += m_edges[i] / 2;
  }
  m_total = m_edges.sum();
}

double length_distortion(const internal::Plane_points& points,
                         const internal::Polygon_lengths& original)
{
  double worst = 0;
  for (Eigen::Index i = 0; i < original.size_of_edges(); ++i) {
    const Eigen::Index next = i + 1 < points.cols() ? i + 1 : 0;
    const double length = (points.col(next) - points.col(i)).stableNorm();
    worst = (std::max)(worst, std::abs(length / original.edges()[i] - 1));
  }
  return worst;
}

}  // namespace Conformal_geometry_processing
