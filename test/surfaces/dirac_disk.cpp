// Tests include/Conformal_geometry_processing/surfaces/spheres.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/surfaces/spheres.h>

#include <gtest/gtest.h>

#include <cmath>

#include "support/bounded_meshes.h"
#include "support/random_delaunay.h"
#include "support/spheres.h"

namespace cgp_test::dirac_disk_tests {

namespace CGP = Conformal_geometry_processing;

double eigenvalue(const CGP::Spin_result& result, double wanted)
{
  return wanted + result.report.eigenvalue;
}

/// the surface of the n-th zero j of J_0 over the unit disk, a surface of revolution
Mesh_view closed_form(const Mesh_view& disk, double j)
{
  return mapped(disk, [j](const Eigen::Vector3d& p) {
    const double r = p.norm(), a = std::cyl_bessel_j(0, j * r), b = std::cyl_bessel_j(1, j * r);
    const Eigen::Vector3d radial = (a * a + b * b) * p;
    return Eigen::Vector3d(radial.x(), radial.y(), (a * a - 1) / j);
  });
}

TEST(Dirac_disk, has_the_zeros_of_bessel_functions_and_their_derivatives_as_eigenvalues)
{
  // j'_11, j_01, j'_21, j_11 = j'_02
  for (const double exact : {1.8411837813, 2.4048255577, 3.0542369283, 3.8317059702}) {
    std::vector<double> h, errors;
    for (int n : {8, 16, 24}) {
      const double wanted = exact + 0.02;
      const CGP::Spin_result result = CGP::dirac_disk(disk(n), wanted);
      h.push_back(1. / n);
      errors.push_back(std::abs(eigenvalue(result, wanted) - exact));
    }
    EXPECT_LT(errors.back(), 2e-3 * exact) << exact;
    EXPECT_GT(slope(h, errors), 1.5) << exact;
  }
}

TEST(Dirac_disk, of_the_first_zero_of_j0_is_the_surface_in_closed_form)
{
  const double j = 2.4048255577;
  std::vector<double> h, errors;
  for (int n : {8, 16, 24}) {
    const Mesh_view mesh = disk(n);
    const CGP::Spin_result result = CGP::dirac_disk(mesh, j);
    h.push_back(1. / n);
    errors.push_back(CGP::align(result.positions, closed_form(mesh, j).positions()).rms);
  }
  EXPECT_LT(errors.back(), 1e-4);
  EXPECT_NEAR(slope(h, errors), 2, 0.2);
}

TEST(Dirac_disk, is_refused_where_a_branch_point_folds_faces_over)
{
  for (const double h : {.1, .05}) {
    const CGP::Spin_result result = CGP::dirac_disk(random_domain(h, 3), 3.0642369283);
    EXPECT_GT(result.report.conformality.flipped_faces, 0);
    EXPECT_EQ(result.report.fault(), CGP::Spin_report::Fault::map);
  }
  EXPECT_TRUE(CGP::dirac_disk(random_domain(.1, 3), 1.85).report);  // it has none
}

TEST(Dirac_disk, of_eigenvalue_zero_is_the_disk)
{
  const Mesh_view mesh = disk(8);
  const CGP::Spin_result result = CGP::dirac_disk(mesh, 0.01);
  EXPECT_NEAR(eigenvalue(result, 0.01), 0, 1e-6);
  EXPECT_LT(CGP::align(result.positions, mesh.positions()).max, 1e-6);
}

TEST(Dirac_disk, is_not_for_closed_surfaces)
{
  EXPECT_THROW((void)CGP::dirac_disk(icosphere(1), 1), CGP::Precondition_error);
}

}  // namespace cgp_test::dirac_disk_tests
