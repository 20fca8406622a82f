// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Closed_curve.h"

#include <Conformal_geometry_processing/mesh/Boundary_frames.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace conformal {
namespace {

CGP::Points points_of(const CGP::Mesh_view& mesh, const std::vector<int>& loop)
{
  CGP::Points points(3, static_cast<Eigen::Index>(loop.size()));
  for (Eigen::Index k = 0; k < points.cols(); ++k)
    points.col(k) = mesh.position(loop[static_cast<std::size_t>(k)]);
  return points;
}

}  // namespace

Closed_curve::Closed_curve(CGP::Points points) : m_points(std::move(points))
{
  const Eigen::Index n = m_points.cols();
  for (Eigen::Index k = 0; k < n; ++k) {
    m_shares.push_back(m_length);
    m_length += (m_points.col((k + 1) % n) - m_points.col(k)).stableNorm();
  }
  if (m_length > 0)
    for (double& share : m_shares) share /= m_length;
}

Closed_curve::Closed_curve(const CGP::Mesh_view& mesh, const std::vector<int>& loop)
    : Closed_curve(points_of(mesh, loop))
{}

Eigen::Vector3d Closed_curve::operator()(double share) const
{
  // The first point has the share 0, so there is one before.
  const auto after = std::upper_bound(m_shares.begin(), m_shares.end(), share);
  const Eigen::Index i = after - m_shares.begin() - 1, next = (i + 1) % m_points.cols();
  const double end = after == m_shares.end() ? 1 : *after, begin = *(after - 1);
  const double t = end > begin ? (share - begin) / (end - begin) : 0;
  return (1 - t) * m_points.col(i) + t * m_points.col(next);
}

CGP::Points tangents(const CGP::Points& closed_polygon)
{
  const Eigen::Index n = closed_polygon.cols();
  CGP::Points T(3, n);
  for (Eigen::Index k = 0; k < n; ++k)
    T.col(k) = CGP::circle_tangent(closed_polygon.col((k + n - 1) % n), closed_polygon.col(k),
                                   closed_polygon.col((k + 1) % n));
  return T;
}

}  // namespace conformal
