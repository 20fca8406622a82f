// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Scale_search.h
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/limbs.h"

namespace cgp_test::scale_search_coarse_tests {

/// Control of scale on meshes of a dozen faces.

namespace CGP = Conformal_geometry_processing;
using CGP::Curvature_potential;

CGP::Spin_transformation_options bounded()
{
  CGP::Spin_transformation_options options;
  options.scales.bound = 2;
  return options;
}

/// a is half of the length of an edge around the middle
Mesh_view octahedron(double a)
{
  const double b = 1.686;
  Points p(3, 6);
  p << 0, a, -a, -a, a, 0,  //
      b, 0, 0, 0, 0, -b,    //
      0, -a, -a, a, a, 0;
  const Mesh_view mesh(
      p, {{0, 4, 1}, {1, 5, 2}, {2, 3, 0}, {3, 5, 4}, {1, 2, 0}, {3, 4, 0}, {4, 5, 1}, {3, 2, 5}});
  return scaled_to_area(mesh, 4 * std::acos(-1.));
}

// On an icosahedron no strong rho makes a conformal map.
TEST(Scale_search_coarse, takes_as_much_of_rho_as_a_coarse_mesh_bears_without_jumps)
{
  const Mesh_view mesh = icosahedron();
  CGP::Spin_transformation transformation(mesh, bounded());
  transformation.limits().map.quasi_conformal = 1.2;
  double last = 0, least = 1;
  for (double amplitude = .3; amplitude < 3; amplitude *= 1.05) {
    const auto rho = Curvature_potential::on_vertices(rings(mesh, amplitude, 5));
    const auto report = transformation.transform(rho).report;
    ASSERT_TRUE(report) << to_string(report.fault());
    const double now = amplitude * report.scales.kept_norm;
    EXPECT_GT(now, .8 * last) << amplitude;
    last = now;
    least = std::min(least, report.scales.kept_norm);
  }
  EXPECT_LT(least, .5);
  transformation.limits().map.quasi_conformal = 10;
  const auto rho = Curvature_potential::on_vertices(rings(mesh, 3, 5));
  const auto lenient = transformation.transform(rho).report;
  EXPECT_GT(lenient.conformality.quasi_conformal.mean, 1.2);
  EXPECT_GT(lenient.scales.kept_norm, 1.5 * least);
}

// Where the search begins, all scales are equal up to rounding, whose gradient is noise.
TEST(Scale_search_coarse, begins_where_all_scales_are_equal)
{
  for (double a = 1.19; a < 1.23; a += .002) {
    const Mesh_view mesh = octahedron(a);
    CGP::Spin_transformation transformation(mesh, bounded());
    const auto rho = Curvature_potential::on_vertices(rings(mesh, 3, 5));
    const auto report = transformation.transform(rho).report;
    EXPECT_TRUE(report) << a << ": " << to_string(report.fault());
    EXPECT_GT(report.scales.kept_norm, .1) << a;
  }
}

}  // namespace cgp_test::scale_search_coarse_tests
