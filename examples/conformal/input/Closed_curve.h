// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <vector>

namespace conformal {

namespace CGP = Conformal_geometry_processing;

/// A closed polygon in space, with its arc length as the parameter.
class Closed_curve {
 public:
  /// \param points 3 x n, n > 0; the last one is followed by the first
  explicit Closed_curve(CGP::Points points);

  /// that of a boundary loop
  Closed_curve(const CGP::Mesh_view& mesh, const std::vector<int>& loop);

  const CGP::Points& points() const { return m_points; }
  double length() const { return m_length; }

  /// how far along the curve each point is, from 0 at the first one: shares of the length
  const std::vector<double>& shares() const { return m_shares; }

  /// the point at a share of the length, in [0, 1)
  Eigen::Vector3d operator()(double share) const;

 private:
  CGP::Points m_points;
  std::vector<double> m_shares;
  double m_length = 0;
};

/// those of the circles through each point and its neighbours; 3 x n, not normalised
CGP::Points tangents(const CGP::Points& closed_polygon);

}  // namespace conformal
