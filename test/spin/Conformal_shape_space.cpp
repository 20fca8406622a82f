// Tests include/Conformal_geometry_processing/spin/Conformal_shape_space.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/Conformal_shape_space.h>
#include <Conformal_geometry_processing/spin/solve_dirac_equation.h>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <vector>

#include "support/bounded_meshes.h"
#include "support/spheres.h"

namespace cgp_test::conformal_shape_space_tests {

namespace CGP = Conformal_geometry_processing;

/// a spherical harmonic of degree k: Re (x + i y)^k
Eigen::VectorXd harmonic(const Mesh_view& sphere, int k)
{
  Eigen::VectorXd phi(sphere.size_of_vertices());
  for (int v = 0; v < sphere.size_of_vertices(); ++v)
    phi[v] =
        std::pow(std::complex<double>(sphere.position(v).x(), sphere.position(v).y()), k).real();
  return phi;
}

/// <phi, S phi> / <phi, phi>
double quotient(const Mesh_view& mesh, const Eigen::VectorXd& phi, const Eigen::VectorXd& image)
{
  const Eigen::VectorXd areas = CGP::vertex_areas(mesh);
  return areas.cwiseProduct(phi).dot(image) / areas.cwiseProduct(phi).dot(phi);
}

TEST(Conformal_shape_space, has_the_principal_curvatures_of_the_round_sphere)
{
  const Mesh_view sphere = icosphere(5);
  const CGP::internal::Conformal_shape_space space(sphere);
  for (int k : {1, 2, 3, 4, 6}) {
    const Eigen::VectorXd phi = harmonic(sphere, k), image = space.shape_operator(phi);
    const double expected = 1 / (std::sqrt(pi) * k * (k + 1)), found = quotient(sphere, phi, image);
    EXPECT_NEAR(found, expected, 0.01 * expected) << k;
    EXPECT_LT((image - found * phi).norm(), 0.02 * image.norm()) << k;
  }
}

TEST(Conformal_shape_space, tells_the_first_and_second_order_of_the_eigenvalue)
{
  const double t = 0.01;
  CGP::Dirac_options options;
  options.tolerance = 1e-11;
  std::vector<double> h, errors;
  for (int level : {2, 3, 4}) {
    const Mesh_view mesh = bumpy_sphere(level);
    const CGP::internal::Conformal_shape_space space(mesh);
    const Eigen::VectorXd rho = rho_of_section_3_on_vertices(mesh);
    CGP::internal::Dirac_system system(mesh);
    const auto gamma = [&](double s) {
      return CGP::solve_dirac_equation(system, CGP::Curvature_potential::on_vertices(s * rho),
                                       options)
          .eigenvalue;
    };
    const double plus = gamma(t), minus = gamma(-t), second = space.second_order(rho);
    EXPECT_NEAR((plus - minus) / (2 * t), space.first_order(rho), 1e-4);
    EXPECT_LT(second, 0);
    h.push_back(mean_edge_length(mesh));
    errors.push_back((plus + minus) / (2 * t * t) / second - 1);
  }
  EXPECT_NEAR(slope(h, errors), 2, 0.3);
  EXPECT_LT(std::abs(errors.back()), 0.005);
}

TEST(Conformal_shape_space, is_not_curved_by_constants_and_scales_as_lengths_do)
{
  const Mesh_view mesh = bumpy_sphere(2);
  const CGP::internal::Conformal_shape_space space(mesh);
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(mesh.size_of_vertices());
  const Eigen::VectorXd phi = rho_of_section_3_on_vertices(mesh);
  EXPECT_LT(space.shape_operator(one).norm(), 1e-12);
  EXPECT_NEAR(space.first_order(one), -1, 1e-14);
  const Eigen::VectorXd image = space.shape_operator(phi);
  EXPECT_LT((space.shape_operator(phi + one) - image).norm(), 1e-9 * image.norm());
  EXPECT_NEAR(CGP::vertex_areas(mesh).dot(image), 0, 1e-9);
  const Mesh_view large = scaled(mesh, 3);
  const Eigen::VectorXd same = CGP::internal::Conformal_shape_space(large).shape_operator(phi / 3);
  EXPECT_LT((same - image / 3).norm(), 1e-8 * image.norm());
}

TEST(Conformal_shape_space, needs_a_closed_surface)
{
  const Mesh_view mesh = disk(2);
  EXPECT_THROW((CGP::internal::Conformal_shape_space(mesh)), CGP::Precondition_error);
}

}  // namespace cgp_test::conformal_shape_space_tests
