// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_CURVES_POLYGON_LENGTHS_H
#define CONFORMAL_GEOMETRY_PROCESSING_CURVES_POLYGON_LENGTHS_H

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace Conformal_geometry_processing {

/// one point or vector of the plane per column
using Plane_points = Eigen::Matrix2Xd;

/// \ingroup PkgCurves
/// \brief the lengths of a polygon: of its edges, and of the dual edges around its vertices.
///
/// Edge i runs from vertex i to the next one, the last edge of a closed polygon to vertex 0; an
/// open polygon has one edge less than vertices. The dual edge of a vertex is half of the edges
/// that meet there. An isometric flow keeps all of these, so it measures them once. O(m).
class Polygon_lengths {
 public:
  Polygon_lengths() = default;

  /// \param points the vertices, 2 x m, m > 1
  Polygon_lengths(const Plane_points& points, bool is_closed)
      : m_edges(points.cols() - (is_closed ? 0 : 1)),
        m_duals(Eigen::VectorXd::Zero(points.cols())),
        m_is_closed(is_closed)
  {
    const Eigen::Index m = points.cols();
    for (Eigen::Index i = 0; i < m_edges.size(); ++i) {
      const Eigen::Index next = i + 1 < m ? i + 1 : 0;
      m_edges[i] = (points.col(next) - points.col(i)).norm();
      m_duals[i] += m_edges[i] / 2;
      m_duals[next] += m_edges[i] / 2;
    }
    m_total = m_edges.sum();
  }

  bool is_closed() const { return m_is_closed; }
  Eigen::Index size_of_vertices() const { return m_duals.size(); }
  Eigen::Index size_of_edges() const { return m_edges.size(); }

  const Eigen::VectorXd& edges() const { return m_edges; }
  const Eigen::VectorXd& duals() const { return m_duals; }

  /// the length of the whole polygon
  double total() const { return m_total; }

 private:
  Eigen::VectorXd m_edges, m_duals;
  double m_total = 0;
  bool m_is_closed = true;
};

/// \relates Polygon_lengths
/// the largest change of length of an edge, relative to what it was
inline double length_distortion(const Plane_points& points, const Polygon_lengths& original)
{
  double worst = 0;
  for (Eigen::Index i = 0; i < original.size_of_edges(); ++i) {
    const Eigen::Index next = i + 1 < points.cols() ? i + 1 : 0;
    const double length = (points.col(next) - points.col(i)).norm();
    worst = (std::max)(worst, std::abs(length / original.edges()[i] - 1));
  }
  return worst;
}

}  // namespace Conformal_geometry_processing

#endif
