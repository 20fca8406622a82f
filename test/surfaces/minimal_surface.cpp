// Tests include/Conformal_geometry_processing/surfaces/minimal_surface.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/surfaces/minimal_surface.h>

#include <gtest/gtest.h>

#include "support/bounded_meshes.h"
#include "support/minimal_surfaces.h"
#include "support/spheres.h"

namespace cgp_test::minimal_surface_tests {

namespace CGP = Conformal_geometry_processing;

TEST(Minimal_surface, of_a_hemisphere_with_its_tangents_is_the_disk_it_was_projected_from)
{
  std::vector<double> h, errors;
  for (int n : {8, 16, 24}) {
    const Mesh_view plane = disk(n), hemisphere = cap_from_disk(plane, pi / 2);
    const CGP::Spin_result result = CGP::spin_to_minimal_surface(hemisphere);
    ASSERT_TRUE(result.report);
    h.push_back(1. / n);
    errors.push_back(CGP::align(result.positions, plane.positions()).rms);
    EXPECT_LT(CGP::willmore_energy(Mesh_view(result.positions, plane.corners())), 0.2 / (n * n));
  }
  EXPECT_LT(errors.back(), 1e-4);
  EXPECT_NEAR(slope(h, errors), 2, 0.2);
}

TEST(Minimal_surface, of_a_cylinder_is_the_catenoid_among_the_many_with_its_tangents)
{
  std::vector<double> h, errors;
  for (int n : {4, 8, 16}) {
    const Mesh_view mesh = cylinder(1, 2, 6 * n, 2 * n);
    const CGP::Spin_result result = CGP::spin_to_minimal_surface(mesh);
    ASSERT_TRUE(result.report);
    const Mesh_view catenoid = mapped(mesh, [](const Eigen::Vector3d& p) {
      const double r = std::cosh(p.z() - 1);
      return Eigen::Vector3d(r * p.x(), r * p.y(), p.z() - 1);
    });
    h.push_back(1. / n);
    errors.push_back(CGP::align(result.positions, catenoid.positions()).rms);
  }
  EXPECT_LT(errors.back(), 1e-4);
  EXPECT_NEAR(slope(h, errors), 2, 0.2);
}

TEST(Minimal_surface, with_the_tangents_of_an_enneper_surface_is_that_to_rounding)
{
  const Mesh_view plane = disk(8);
  CGP::Spin_transformation_options options{
      CGP::Boundary_condition::tangents(enneper_tangents(plane))};
  options.dirac.tolerance = 1e-13;
  const CGP::Spin_result result = CGP::spin_to_minimal_surface(plane, options);
  ASSERT_TRUE(result.report);
  EXPECT_LT(CGP::align(result.positions, enneper(plane).positions()).max, 1e-12);
}

TEST(Minimal_surface, counts_several_singular_values_as_zero_only_where_there_are_several_loops)
{
  EXPECT_EQ(CGP::minimal_kernel_tolerance(disk(4)), 0);
  const Mesh_view ring = annulus(1, 2, 16, 4);
  EXPECT_GT(CGP::minimal_kernel_tolerance(ring), 0);
  EXPECT_NEAR(CGP::minimal_kernel_tolerance(scaled(ring, 2)),
              CGP::minimal_kernel_tolerance(ring) / 2, 1e-15);
}

TEST(Minimal_surface, is_not_for_closed_surfaces)
{
  EXPECT_THROW((void)CGP::spin_to_minimal_surface(icosphere(1)), CGP::Precondition_error);
}

}  // namespace cgp_test::minimal_surface_tests
