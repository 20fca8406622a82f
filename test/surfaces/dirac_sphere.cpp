// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests surfaces/spheres.h
#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/operators/calculus.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/mean_curvature.h>
#include <Conformal_geometry_processing/spin/Dirac_spectrum.h>
#include <Conformal_geometry_processing/surfaces/spheres.h>

#include <gtest/gtest.h>

#include "support/bounded_meshes.h"
#include "support/random.h"
#include "support/spheres.h"

#include <cmath>
#include <utility>
#include <vector>

namespace cgp_test::dirac_sphere_tests {

using Conformal_geometry_processing::spherical_harmonic;
using Complex = std::complex<double>;
namespace CGP = Conformal_geometry_processing;

TEST(Spherical_harmonic, is_a_polynomial_for_small_degrees)
{
  Random random(1);
  for (int i = 0; i < 10; ++i) {
    const Eigen::Vector3d p = random.vector().normalized();
    const double x = p.x(), y = p.y(), z = p.z();
    EXPECT_NEAR(std::abs(spherical_harmonic(0, 0, p) - std::sqrt(1 / (4 * pi))), 0, 1e-15);
    EXPECT_NEAR(std::abs(spherical_harmonic(1, 0, p) - std::sqrt(3 / (4 * pi)) * z), 0, 1e-15);
    EXPECT_NEAR(std::abs(spherical_harmonic(1, 1, p) + std::sqrt(3 / (8 * pi)) * Complex(x, y)), 0,
                1e-15);
    EXPECT_NEAR(std::abs(spherical_harmonic(1, -1, p) - std::sqrt(3 / (8 * pi)) * Complex(x, -y)),
                0, 1e-15);
    const Complex expected = std::sqrt(15 / (32 * pi)) * Complex(x, y) * Complex(x, y);
    EXPECT_NEAR(std::abs(spherical_harmonic(2, 2, p) - expected), 0, 1e-15);
    EXPECT_NEAR(
        std::abs(spherical_harmonic(2, -1, p) - std::sqrt(15 / (8 * pi)) * z * Complex(x, -y)), 0,
        1e-15);
  }
}

TEST(Spherical_harmonic, fulfils_the_addition_theorem)
{
  Random random(2);
  const Eigen::Vector3d p = random.vector();
  for (int l : {3, 7, 20}) {
    double sum = 0;
    for (int m = -l; m <= l; ++m) sum += std::norm(spherical_harmonic(l, m, p));
    EXPECT_NEAR(sum, (2 * l + 1) / (4 * pi), 1e-13 * (2 * l + 1)) << l;
  }
}

TEST(Spherical_harmonic, sums_to_the_polynomial_of_legendre_of_two_points)
{
  Random random(3);
  const Eigen::Vector3d p = random.vector(), q = random.vector();
  const double t = p.normalized().dot(q.normalized());
  Complex sum = 0;
  for (int m = -4; m <= 4; ++m)
    sum += spherical_harmonic(4, m, p) * std::conj(spherical_harmonic(4, m, q));
  const double legendre = (35 * t * t * t * t - 30 * t * t + 3) / 8;
  EXPECT_NEAR(std::abs(sum - 9 / (4 * pi) * legendre), 0, 1e-14);
}

TEST(Spherical_harmonic, vanishes_at_the_poles_and_beyond_its_degree)
{
  const Eigen::Vector3d pole(0, 0, -2);
  EXPECT_EQ(spherical_harmonic(3, 2, pole), 0.);
  EXPECT_NEAR(spherical_harmonic(3, 0, pole).real(), -std::sqrt(7 / (4 * pi)), 1e-15);
  EXPECT_EQ(spherical_harmonic(2, 3, pole), 0.);
  EXPECT_EQ(spherical_harmonic(2, -3, pole), 0.);
}

Quaternion_vector<double> sampled(const Mesh_view& sphere, int kappa, int s)
{
  Quaternion_vector<double> omega(sphere.size_of_vertices());
  for (int v = 0; v < sphere.size_of_vertices(); ++v)
    omega[v] = CGP::spherical_spinor(kappa, s, sphere.position(v));
  return omega;
}

TEST(Spherical_spinor, has_the_eigenvalue_minus_kappa_minus_one)
{
  const Mesh_view sphere = icosphere(5);
  for (int kappa : {-4, -3, -2, -1, 1, 2, 3, 4})
    for (int s = 0; s < std::abs(kappa); ++s) {
      const double gamma =
          CGP::dirac_quotient(sphere, CGP::no_potential(sphere), sampled(sphere, kappa, s));
      EXPECT_NEAR(gamma, -(kappa + 1), 2e-3 * std::abs(kappa + 1) + 1e-12) << kappa << ' ' << s;
    }
}

TEST(Spherical_spinor, solves_the_dirac_equation_on_every_face_to_first_order)
{
  for (int s : {0, 1, 2}) {
    std::vector<double> h, errors;
    for (int level : {2, 3, 4}) {
      const Mesh_view sphere = icosphere(level);
      const auto omega = sampled(sphere, -3, s);
      const auto image = CGP::dirac(sphere) * omega, mean = CGP::averaging(sphere) * omega;
      const Eigen::VectorXd areas = CGP::face_areas(sphere);
      double error = 0, size = 0;
      for (Eigen::Index f = 0; f < areas.size(); ++f) {
        error += areas[f] * squared_norm(image[f] - 2. * mean[f]);
        size += areas[f] * squared_norm(2. * mean[f]);
      }
      h.push_back(mean_edge_length(sphere));
      errors.push_back(std::sqrt(error / size));
    }
    EXPECT_NEAR(slope(h, errors), 1, 0.1) << s;
    EXPECT_LT(errors.back(), 0.1) << s;  // with Y_(l, mu - 1/2) in psi_2 it stays of size one
  }
}

TEST(Spherical_spinor, of_minus_s_minus_one_is_that_of_s_times_a_constant)
{
  Random random(1);
  for (int kappa : {-3, 2})
    for (int s = 0; s < std::abs(kappa); ++s) {
      const Eigen::Vector3d p = random.vector(), q = random.vector();
      const auto ratio = [&](const Eigen::Vector3d& x) {
        return inverse(CGP::spherical_spinor(kappa, s, x)) *
               CGP::spherical_spinor(kappa, -s - 1, x);
      };
      EXPECT_LT(norm(ratio(p) - ratio(q)), 1e-12) << kappa << ' ' << s;
      EXPECT_NEAR(norm(ratio(p)), 1, 1e-12);
    }
}

TEST(Spherical_spinor, is_orthonormal)
{
  const Mesh_view sphere = icosphere(4);
  const Eigen::VectorXd areas = CGP::vertex_areas(sphere);
  for (int s : {0, 1}) {
    const auto omega = sampled(sphere, 2, s);
    EXPECT_NEAR(inner_product(omega, areas, omega).w, 1, 5e-3);
    EXPECT_LT(norm(inner_product(omega, areas, sampled(sphere, -3, s))), 5e-3);
  }
  EXPECT_LT(norm(inner_product(sampled(sphere, 2, 0), areas, sampled(sphere, 2, 1))), 5e-3);
}

TEST(Spherical_spinor, of_minus_one_is_constant)
{
  EXPECT_LT(norm(CGP::spherical_spinor(-1, 0, {1, 2, 3}) - CGP::spherical_spinor(-1, 0, {0, 1, 0})),
            1e-15);
}

TEST(Spherical_spinor, refuses_numbers_that_do_not_belong_to_one)
{
  EXPECT_THROW(CGP::require_spherical_spinor(0, 0, "test"), CGP::Precondition_error);
  EXPECT_THROW(CGP::require_spherical_spinor(2, 2, "test"), CGP::Precondition_error);
  EXPECT_THROW(CGP::require_spherical_spinor(-2, -3, "test"), CGP::Precondition_error);
  EXPECT_NO_THROW(CGP::require_spherical_spinor(-2, 1, "test"));
}

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

// The half-density of mean curvature is kappa everywhere, so a part of the surface has the energy
// of its part of the sphere: that with |z| < c the share c.
TEST(Dirac_sphere, with_branch_points_has_its_energy_apart_from_them)
{
  const double c = .8;
  for (const auto& [kappa, s] : {std::pair(-2, 1), std::pair(-3, 1), std::pair(-3, 2)}) {
    std::vector<double> h, errors;
    for (const int level : {4, 5, 6}) {
      const Mesh_view sphere = icosphere(level);
      const Mesh_view image(CGP::spin_to_dirac_sphere(sphere, kappa, s).positions,
                            sphere.corners());
      const Eigen::VectorXd energies =
          CGP::voronoi_areas(image).cwiseProduct(CGP::mean_curvature(image).cwiseAbs2());
      const Eigen::ArrayXd outside =
          (sphere.positions().row(2).transpose().array().abs() < c).cast<double>();
      const double share = outside.matrix().dot(CGP::voronoi_areas(sphere)) / (4 * pi);
      h.push_back(mean_edge_length(sphere));
      errors.push_back(
          std::abs(outside.matrix().dot(energies) / (4 * pi * kappa * kappa * share) - 1));
    }
    EXPECT_LT(errors.back(), .01) << kappa << ' ' << s;
    EXPECT_GT(slope(h, errors), 1.5) << kappa << ' ' << s;
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
