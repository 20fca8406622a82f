// Tests include/Conformal_geometry_processing/measure/energies.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/energies.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/meshes.h"
#include "support/random.h"

namespace cgp_test::enclosure_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::internal::Enclosure_gradient;

TEST(Enclosure, of_a_cube)
{
  const CGP::Enclosure e = CGP::enclosure(cube());
  EXPECT_NEAR(e.area, 6, 1e-14);
  EXPECT_NEAR(e.volume, 1, 1e-14);
  EXPECT_NEAR(e.reduced_volume, std::sqrt(pi / 6), 1e-14);
  EXPECT_NEAR(CGP::enclosure(with_reversed_faces(cube())).volume, -1, 1e-14);
}

TEST(Enclosure, tends_to_that_of_the_ball)
{
  std::vector<double> h, error;
  for (const int level : {2, 3, 4}) {
    const CGP::Enclosure e = CGP::enclosure(icosphere(level));
    h.push_back(mean_edge_length(icosphere(level)));
    error.push_back(1 - e.reduced_volume);
    EXPECT_GT(error.back(), 0);
    EXPECT_NEAR(e.volume, 4 * pi / 3, 4 * h.back() * h.back());
  }
  EXPECT_NEAR(slope(h, error), 2, .1);
}

TEST(Enclosure, reduced_volume_has_no_unit_and_no_place)
{
  const Mesh_view mesh = bumpy_sphere(2);
  const double v = CGP::enclosure(mesh).reduced_volume;
  for (const double scale : {3., 1e-120, 1e140})
    EXPECT_NEAR(CGP::enclosure(scaled(mesh, scale)).reduced_volume, v, 1e-13);
  const Mesh_view away(mesh.positions().colwise() + Eigen::Vector3d(1e3, 2e3, -1e3),
                       mesh.corners());
  EXPECT_NEAR(CGP::enclosure(away).reduced_volume, v, 1e-10);
}

TEST(Enclosure, has_the_derivative_of_differences)
{
  const Mesh_view mesh = perturbed(bumpy_sphere(2), .1);
  const Points f = mesh.positions(), d = perturbed(mesh, .3).positions() - f;
  const Enclosure_gradient g(mesh, f);
  const double h = 1e-5;
  const Enclosure_gradient after(mesh, f + h * d), before(mesh, f - h * d);
  const auto along = [&](const Points& gradient) { return gradient.cwiseProduct(d).sum(); };
  EXPECT_NEAR((after.area - before.area) / (2 * h), along(g.of_area), 1e-7);
  EXPECT_NEAR((after.volume - before.volume) / (2 * h), along(g.of_volume), 1e-7);
  EXPECT_NEAR(std::log(after.reduced_volume() / before.reduced_volume()) / (2 * h),
              along(g.of_log_reduced_volume()), 1e-7);
}

TEST(Enclosure, is_that_without_faces_of_no_area)
{
  const Enclosure_gradient g(cube(), Points::Zero(3, cube().size_of_vertices()));
  EXPECT_EQ(g.area, 0);
  EXPECT_TRUE(g.of_area.isZero(0));
}

}  // namespace cgp_test::enclosure_tests
