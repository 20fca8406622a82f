// Tests include/Conformal_geometry_processing/surfaces/minimal_surface.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/surfaces/minimal_surface.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <gtest/gtest.h>

#include "support/minimal_surfaces.h"
#include "support/spheres.h"

namespace cgp_test::associated_family_tests {

namespace CGP = Conformal_geometry_processing;

TEST(Associated_family, has_the_surface_itself_and_its_mirror_image_in_a_point)
{
  const Mesh_view mesh = catenoid_strip(6);
  const CGP::Associated_family family(mesh);
  const Points start = mesh.positions().colwise() - mesh.positions().rowwise().mean();
  const CGP::internal::Associated_surface same = family(0);
  EXPECT_LT((same.positions - start).norm(), 1e-12 * start.norm());
  EXPECT_LT(same.closure_residual, 1e-13);
  // Vertex normals differ from face normals: an error of second order.
  EXPECT_LT((family(pi).positions + start).norm(), 0.02 * start.norm());
}

TEST(Associated_family, of_a_catenoid_has_the_helicoid_a_quarter_of_a_turn_on)
{
  std::vector<double> h, errors, residuals;
  for (int n : {6, 12, 24}) {
    const CGP::Associated_family family(catenoid_strip(n));
    const CGP::internal::Associated_surface surface = family(pi / 2);
    h.push_back(1. / n);
    errors.push_back(CGP::align(surface.positions, helicoid_strip(n).positions()).rms);
    residuals.push_back(surface.closure_residual);
  }
  EXPECT_LT(errors.back(), 2e-3);
  EXPECT_GT(slope(h, errors), 1.5);
  EXPECT_GT(slope(h, residuals), 0.9);
}

TEST(Associated_family, keeps_lengths)
{
  const Mesh_view mesh = catenoid_strip(12);
  const CGP::Associated_family family(mesh);
  for (double angle : {0.5, 1., 2.}) {
    const Mesh_view member(family(angle).positions, mesh.corners());
    EXPECT_NEAR(area(member), area(mesh), 0.01 * area(mesh));
    EXPECT_NEAR(mean_edge_length(member), mean_edge_length(mesh), 0.01 * mean_edge_length(mesh));
  }
}

TEST(Associated_family, of_a_surface_that_is_not_minimal_does_not_close)
{
  EXPECT_GT(CGP::Associated_family(cap_from_disk(disk(12), 1.2))(pi / 2).closure_residual, 0.1);
}

TEST(Associated_family, refuses_unsuitable_meshes)
{
  EXPECT_THROW((CGP::Associated_family{Mesh_view{}}), CGP::Precondition_error);
}

}  // namespace cgp_test::associated_family_tests
