// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace conformal {

/// a polygon in the plane, y up, as a file has it
struct Plane_curve {
  std::string name;  ///< what messages call it
  Eigen::Matrix2Xd points;
  bool is_closed = false;  ///< the last point is followed by the first
};

/// how files with curves are read
struct Curve_reading {
  std::optional<bool> are_closed;  ///< if empty, determined by the file
  int samples = 16;                ///< points of each Bezier segment
};

/// the points as columns
Eigen::Matrix2Xd columns(const std::vector<Eigen::Vector2d>& points);

}  // namespace conformal
