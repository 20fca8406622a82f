// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <vector>

namespace conformal {

/// the elliptic arc of a path, `A rx ry rotation large sweep x y`
struct Svg_arc {
  Eigen::Vector2d radii;
  double rotation = 0;  ///< of the x axis of the ellipse, in degrees
  bool is_large = false, sweeps = false;
  Eigen::Vector2d from, to;
};

/// Points of an arc after the first one, to the last one: so many for each quarter of an ellipse,
/// or for a part of a quarter. Radii that are too small are enlarged, as SVG says; where one is
/// zero the arc is a line.
std::vector<Eigen::Vector2d> sample(const Svg_arc& arc, int samples);

}  // namespace conformal
