// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "refine_curve.h"

#include <cmath>

namespace conformal {

void refine(Plane_curve& curve, int count)
{
  const Eigen::Matrix2Xd& p = curve.points;
  const Eigen::Index m = p.cols(), edges = curve.is_closed ? m : m - 1;
  double length = 0;
  for (Eigen::Index i = 0; i < edges; ++i) length += (p.col((i + 1) % m) - p.col(i)).stableNorm();
  if (!(length > 0) || !std::isfinite(length)) return;
  std::vector<Eigen::Vector2d> points;
  for (Eigen::Index i = 0; i < edges; ++i) {
    const Eigen::Vector2d edge = p.col((i + 1) % m) - p.col(i);
    // A curve that has its points already keeps them: rounding does not divide an edge.
    const int parts = static_cast<int>(std::ceil(edge.stableNorm() / length * count - 1e-9));
    points.emplace_back(p.col(i));
    for (int k = 1; k < parts; ++k) points.emplace_back(p.col(i) + edge * (double(k) / parts));
  }
  if (!curve.is_closed) points.emplace_back(p.col(m - 1));
  curve.points = columns(points);
}

}  // namespace conformal
