// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/flow/Curvature_direction_ref.h
#include <Conformal_geometry_processing/flow/Curvature_direction_ref.h>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace cgp_test::curvature_direction_ref_tests {

namespace CGP = Conformal_geometry_processing;

struct Only_a_direction {
  Eigen::VectorXd operator()(const Mesh_view&) const { return {}; }
};

TEST(Curvature_direction_ref, has_an_energy_if_the_direction_has)
{
  const CGP::internal::Curvature_direction_ref own, other = Only_a_direction();
  EXPECT_TRUE(own.has_energy());
  EXPECT_FALSE(other.has_energy());
  const Mesh_view mesh = bumpy_sphere(2);
  EXPECT_EQ(other.energy(mesh, mesh), CGP::willmore_energy(mesh));
  EXPECT_EQ(own.energy(mesh, mesh), CGP::willmore_energy(mesh));
}

TEST(Curvature_direction_ref, takes_directions_of_surfaces_in_the_unit_of_the_surface)
{
  const Mesh_view mesh = bumpy_sphere(2);
  const CGP::internal::Curvature_direction_ref own, other = Only_a_direction();
  EXPECT_EQ(own.rate(mesh, mesh, 2), CGP::Willmore_direction()(mesh) / 2);
  EXPECT_EQ(other.rate(mesh, mesh, 2), Only_a_direction()(mesh));
}

}  // namespace cgp_test::curvature_direction_ref_tests
