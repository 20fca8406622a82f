// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace Conformal_geometry_processing {

namespace internal {

/// One point or vector of the plane per column
using Plane_points = Eigen::Matrix2Xd;

/// \ingroup PkgCurves
/// \brief The lengths of the edges of a polygon, and of the dual edges of its vertices.
///
/// Edge i runs from vertex i to the next one, the last edge of a closed polygon to vertex 0; an
/// open polygon has one edge less than vertices. The dual edge of a vertex consists of half of each
/// incident edge. An isometric flow preserves these lengths and computes them only once. O(m).
class Polygon_lengths {
 public:
  Polygon_lengths() = default;

  /// \param points the vertices, 2 x m, m > 1
  Polygon_lengths(const Plane_points& points, bool is_closed);

  bool is_closed() const { return m_is_closed; }
  Eigen::Index size_of_vertices() const { return m_duals.size(); }
  Eigen::Index size_of_edges() const { return m_edges.size(); }

  const Eigen::VectorXd& edges() const { return m_edges; }
  const Eigen::VectorXd& duals() const { return m_duals; }

  /// Length of the whole polygon
  double total() const { return m_total; }

 private:
  Eigen::VectorXd m_edges, m_duals;
  double m_total = 0;
  bool m_is_closed = true;
};

}  // namespace internal

/// \ingroup PkgCurves
/// Returns the maximal relative change of the length of an edge
double length_distortion(const internal::Plane_points& points,
                         const internal::Polygon_lengths& original);

}  // namespace Conformal_geometry_processing
