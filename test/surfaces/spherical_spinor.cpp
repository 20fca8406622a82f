// Tests include/Conformal_geometry_processing/surfaces/spherical_spinor.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/averaging.h>
#include <Conformal_geometry_processing/operators/dirac.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/surfaces/spherical_spinor.h>

#include <gtest/gtest.h>

#include <cmath>

#include "support/random.h"
#include "support/spheres.h"

namespace cgp_test::spherical_spinor_tests {

namespace CGP = Conformal_geometry_processing;

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

}  // namespace cgp_test::spherical_spinor_tests
