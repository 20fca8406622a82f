// Tests include/Conformal_geometry_processing/surfaces/dirac_sphere.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/spin/Dirac_spectral_problem.h>
#include <Conformal_geometry_processing/surfaces/dirac_sphere.h>

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "support/bounded_meshes.h"
#include "support/spheres.h"

namespace cgp_test::dirac_sphere_tests {

namespace CGP = Conformal_geometry_processing;

double energy(const CGP::Spin_result& result, const Mesh_view& mesh)
{
  return CGP::willmore_energy(Mesh_view(result.positions, mesh.corners())) / (4 * pi);
}

TEST(Dirac_sphere, has_the_eigenvalue_and_the_energy_of_its_kappa)
{
  const Mesh_view sphere = icosphere(5);
  for (int kappa : {-2, 2, -3, 3, -4, 4}) {
    const CGP::Spin_result result = CGP::spin_to_dirac_sphere(sphere, kappa, 0);
    ASSERT_TRUE(result.report) << kappa;
    EXPECT_NEAR(result.report.eigenvalue, -(kappa + 1), 2e-3 * std::abs(kappa + 1)) << kappa;
    EXPECT_NEAR(energy(result, sphere), kappa * kappa, 0.01 * kappa * kappa) << kappa;
    EXPECT_LT(result.report.closure_residual, 1e-3) << kappa;
    EXPECT_LT(result.report.conformality.quasi_conformal.max, 1.1) << kappa;
  }
}

TEST(Dirac_sphere, closes_to_second_order)
{
  for (const auto& [kappa, s] : {std::pair(-2, 0), std::pair(3, 0), std::pair(-3, 1)}) {
    std::vector<double> h, errors;
    for (int level : {2, 3, 4}) {
      const Mesh_view sphere = icosphere(level);
      h.push_back(mean_edge_length(sphere));
      errors.push_back(CGP::spin_to_dirac_sphere(sphere, kappa, s).report.closure_residual);
    }
    EXPECT_NEAR(slope(h, errors), 2, 0.25) << kappa;
  }
}

TEST(Dirac_sphere, of_minus_one_is_the_sphere)
{
  const Mesh_view sphere = mapped(
      icosphere(3), [](const Eigen::Vector3d& p) { return Eigen::Vector3d(3 * p.array() + 5); });
  const CGP::Spin_result result = CGP::spin_to_dirac_sphere(sphere, -1, 0);
  ASSERT_TRUE(result.report);
  EXPECT_LT(CGP::align(result.positions, sphere.positions()).max, 1e-10);
}

TEST(Dirac_sphere, of_the_opposite_kappa_is_the_mirror_image_in_a_point)
{
  const Mesh_view sphere = icosphere(4);
  for (int kappa : {2, 3}) {
    const Points a = CGP::spin_to_dirac_sphere(sphere, kappa, 0).positions,
                 b = CGP::spin_to_dirac_sphere(sphere, -kappa, 0).positions;
    EXPECT_LT(CGP::align(Points(-a), b).rms, 0.01) << kappa;
  }
}

TEST(Surface_of_spin, of_a_constant_is_the_surface)
{
  const Mesh_view mesh = bumpy_sphere(2);
  const auto constant =
      CGP::Quaternion_vector<double>::Constant(mesh.size_of_vertices(), {.3, -2, 1, 4});
  const CGP::Spin_result result = CGP::surface_of_spin(mesh, constant);
  ASSERT_TRUE(result.report);
  EXPECT_LT(CGP::align(result.positions, mesh.positions()).max, 1e-12);
  EXPECT_NEAR(result.report.eigenvalue, 0, 1e-14);
}

TEST(Surface_of_spin, of_any_eigenfunction_has_the_energy_of_its_eigenvalue)
{
  const Mesh_view sphere = icosphere(4);
  const CGP::internal::Dirac_spectrum s =
      CGP::internal::Dirac_spectral_problem(sphere).find(CGP::no_potential(sphere), 7);
  ASSERT_TRUE(s.converged);
  for (int k = 0; k < 7; ++k) {
    const CGP::Spin_result result = CGP::surface_of_spin(sphere, s.vectors.col(k));
    ASSERT_TRUE(result.report);
    EXPECT_NEAR(result.report.eigenvalue, s.eigenvalues[k], 1e-6);
    EXPECT_LT(result.report.closure_residual, 5e-3) << k;
    const double expected = std::pow(1 + std::round(s.eigenvalues[k]), 2);
    EXPECT_NEAR(energy(result, sphere), expected, 0.05 * expected) << k;
  }
}

TEST(Directions_on_sphere, do_not_depend_on_center_and_radius)
{
  const Mesh_view sphere = icosphere(2);
  for (const double size : {1e-150, 1e-80, 7., 1e80, 1e150}) {
    const Mesh_view moved = mapped(sphere, [&](const Eigen::Vector3d& p) {
      return Eigen::Vector3d(size * (p + Eigen::Vector3d(.1, -3, .4)));
    });
    EXPECT_LT((CGP::directions_on_sphere(moved, "test") - sphere.positions()).norm(), 1e-11);
    EXPECT_THROW((void)CGP::directions_on_sphere(with_reversed_faces(moved), "test"),
                 CGP::Precondition_error);
  }
}

TEST(Dirac_sphere, refuses_surfaces_that_are_no_spheres)
{
  EXPECT_THROW((void)CGP::spin_to_dirac_sphere(bumpy_sphere(2), 2, 0), CGP::Precondition_error);
  EXPECT_THROW((void)CGP::spin_to_dirac_sphere(with_reversed_faces(icosphere(2)), 2, 0),
               CGP::Precondition_error);
  EXPECT_THROW((void)CGP::spin_to_dirac_sphere(cap_from_disk(disk(3), 1), 2, 0),
               CGP::Precondition_error);
  EXPECT_THROW((void)CGP::spin_to_dirac_sphere(icosphere(1), 0, 0), CGP::Precondition_error);
  EXPECT_THROW((void)CGP::surface_of_spin(icosphere(1), CGP::Quaternion_vector<double>(3)),
               CGP::Precondition_error);
}

}  // namespace cgp_test::dirac_sphere_tests
