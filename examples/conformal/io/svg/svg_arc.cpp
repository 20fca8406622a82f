// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "svg_arc.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace conformal {
namespace {

const double pi = std::acos(-1.);

double angle_of(const Eigen::Vector2d& v)
{
  return std::atan2(v.y(), v.x());
}

}  // namespace

// In the coordinates where the ellipse is the unit circle, the ends are p and q, and the center is
// on the perpendicular bisector of pq, on the side given by the flags.
std::vector<Eigen::Vector2d> sample(const Svg_arc& arc, int samples)
{
  if (arc.radii.cwiseAbs().minCoeff() == 0 || arc.from == arc.to) return {arc.to};
  const Eigen::Rotation2Dd turn(arc.rotation * pi / 180);
  Eigen::Vector2d radii = arc.radii.cwiseAbs();
  Eigen::Vector2d half = (turn.inverse() * (arc.to - arc.from)).cwiseQuotient(radii) / 2;
  const double enlargement = std::max(half.norm(), 1.);
  radii *= enlargement;
  half /= enlargement;
  const double side = arc.is_large == arc.sweeps ? -1 : 1;
  const double height = std::sqrt(std::max(1 - half.squaredNorm(), 0.)) / half.norm();
  const Eigen::Vector2d to_center = side * height * Eigen::Vector2d(-half.y(), half.x());
  const Eigen::Vector2d p = -half - to_center, q = half - to_center;
  double span = angle_of(q) - angle_of(p);
  if (arc.sweeps && span < 0) span += 2 * pi;
  if (!arc.sweeps && span > 0) span -= 2 * pi;
  const int quarters = std::max(1, static_cast<int>(std::ceil(std::abs(span) / (pi / 2) - 1e-9)));
  const Eigen::Vector2d center =
      (arc.from + arc.to) / 2 + turn * Eigen::Vector2d(radii.cwiseProduct(to_center));
  std::vector<Eigen::Vector2d> points;
  for (int i = 1; i < quarters * samples; ++i) {
    const double angle = angle_of(p) + span * i / (quarters * samples);
    const Eigen::Vector2d on_circle(std::cos(angle), std::sin(angle));
    points.emplace_back(center + turn * Eigen::Vector2d(radii.cwiseProduct(on_circle)));
  }
  points.push_back(arc.to);
  return points;
}

}  // namespace conformal
