// Tests include/Conformal_geometry_processing/surfaces/spheres.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/surfaces/spheres.h>

#include <gtest/gtest.h>

#include "support/mesh_tools.h"

namespace cgp_test::geodesic_sphere_tests {

namespace CGP = Conformal_geometry_processing;

TEST(Geodesic_sphere, is_a_closed_sphere_of_twenty_n_squared_faces_with_normals_outward)
{
  for (int n : {1, 2, 5}) {
    const Mesh_view mesh = CGP::geodesic_sphere(n);
    EXPECT_EQ(mesh.size_of_faces(), 20 * n * n);
    EXPECT_EQ(mesh.size_of_vertices(), 10 * n * n + 2);
    EXPECT_NO_THROW(CGP::require_surface(mesh, "test"));
    EXPECT_NO_THROW(CGP::require_closed(mesh, "test"));
    EXPECT_GT(CGP::signed_volume(mesh), 0);
    EXPECT_LT((mesh.positions().colwise().norm().array() - 1).abs().maxCoeff(), 1e-15);
  }
}

TEST(Geodesic_sphere, has_the_area_of_the_sphere_up_to_second_order)
{
  std::vector<double> h, errors;
  for (int n : {4, 8, 16}) {
    h.push_back(1. / n);
    errors.push_back(4 * pi - area(CGP::geodesic_sphere(n)));
  }
  EXPECT_NEAR(slope(h, errors), 2, 0.05);
}

TEST(Geodesic_sphere, refuses_a_frequency_of_zero)
{
  EXPECT_THROW((void)CGP::geodesic_sphere(0), CGP::Precondition_error);
}

}  // namespace cgp_test::geodesic_sphere_tests
