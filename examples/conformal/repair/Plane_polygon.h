// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <vector>

namespace conformal {

/// the corners in the plane, counter-clockwise
using Plane_polygon = std::vector<Eigen::Vector2d>;

/// twice the area of a triangle, negative if it is clockwise
inline double twice_area(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                         const Eigen::Vector2d& c)
{
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

}  // namespace conformal
