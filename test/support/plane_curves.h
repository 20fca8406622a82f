// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "support/mesh_tools.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

/// Closed curves in the plane, sampled at equal steps of their parameter, and their measures,
/// computed with complex numbers.
namespace cgp_test {

using Curve = Eigen::Matrix2Xd;

/// the points shape(t), t = 2 pi i / m
template <class Shape>
Curve sampled(int m, Shape shape)
{
  Curve points(2, m);
  for (int i = 0; i < m; ++i) {
    const std::complex<double> z = shape(2 * pi * i / m);
    points.col(i) = Eigen::Vector2d(z.real(), z.imag());
  }
  return points;
}

/// turns once
Curve flower(int m);

/// turns once
Curve ellipse(int m);

/// does not turn
Curve figure_eight(int m);

/// turns twice
Curve limacon(int m);

/// turns three times
Curve rose(int m);

/// the edge after vertex i, of which there is one even after the last vertex
std::complex<double> edge(const Curve& points, Eigen::Index i);

double length_of(const Curve& points);

/// the turning angles of a closed polygon
std::vector<double> angles_of(const Curve& points);

/// the curvatures of a closed polygon: angle by dual length
Eigen::VectorXd curvatures_of(const Curve& points);

/// sum kappa^2 d times the length of a closed polygon
double energy_times_length(const Curve& points);

/// the turning number of a closed polygon
double turns_of(const Curve& points);

/// the largest relative change of the length of an edge of a closed polygon
double distortion(const Curve& before, const Curve& after);

/// the curve without its last points
Curve first_points(const Curve& points, Eigen::Index count);

}  // namespace cgp_test
