// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgCurves
/// \brief A compensated running sum of vectors of the plane, accurate to one rounding.
///
/// The vertices of a polygon are such sums of its edges. Without compensation, their rounding
/// errors grow with the number of edges, and accumulate in the edge that closes the polygon.
class Compensated_sum {
 public:
  void add(const Eigen::Vector2d& x);

  Eigen::Vector2d value() const { return m_sum + m_lost; }

 private:
  Eigen::Vector2d m_sum = Eigen::Vector2d::Zero(), m_lost = Eigen::Vector2d::Zero();
};

}  // namespace Conformal_geometry_processing::internal
