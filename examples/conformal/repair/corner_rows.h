// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/data/Surface_file.h"

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>

namespace conformal {

/// whether two corners have the same values, or both none
inline bool is_same_row(const Corner_values& values, int i, int j)
{
  if (i < 0 || j < 0) return i < 0 && j < 0;
  return i == j ||
         values.values[static_cast<std::size_t>(i)] == values.values[static_cast<std::size_t>(j)];
}

/// Adds the row (1 - s) times row i plus s times row j.
/// \returns its number, -1 if either is
/// missing
inline int append_between(Corner_values& values, int i, int j, double s)
{
  if (i < 0 || j < 0) return -1;
  const auto row = [&](int k) {
    return Eigen::Vector3d::Map(values.values[static_cast<std::size_t>(k)].data());
  };
  const Eigen::Vector3d between = (1 - s) * row(i) + s * row(j);
  values.values.push_back({between.x(), between.y(), between.z()});
  return static_cast<int>(values.values.size()) - 1;
}

/// where the foot of the perpendicular from c on the line ab is: 0 at a, 1 at b, not beyond
inline double share_along(const Point& a, const Point& b, const Point& c)
{
  const Eigen::Vector3d p = Eigen::Vector3d::Map(a.data()),
                        edge = Eigen::Vector3d::Map(b.data()) - p;
  const double length = edge.stableNorm();
  if (!(length > 0)) return 0;
  return std::clamp((Eigen::Vector3d::Map(c.data()) - p).dot(edge / length) / length, 0., 1.);
}

}  // namespace conformal
