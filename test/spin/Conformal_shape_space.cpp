// Tests include/Conformal_geometry_processing/spin/Dirac_system.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/calculus.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>
#include <Conformal_geometry_processing/spin/solve_dirac_equation.h>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <vector>

#include "support/spheres.h"

namespace cgp_test::conformal_shape_space_tests {

namespace CGP = Conformal_geometry_processing;

/// \brief the space of conformal shapes near a closed surface: the hypersurface of the
/// half-densities rho |df| for which the Dirac equation has the eigenvalue zero [CGP 4.5.1].
///
/// Its normal at the surface is 1. It is curved: along rho = t phi with mean zero, gamma =
/// second_order(phi) t^2 + O(t^3). At round spheres, its principal curvatures are 1 / (sqrt(pi) k
/// (k + 1)) for the spherical harmonics of degree k.
class Shape_space {
 public:
  explicit Shape_space(const Mesh_view& mesh) : m_mesh(mesh), m_system(mesh)
  {
    m_system.prepare_response();
  }

  /// S(phi) = 2 A^(-1/2) Re lambda-dot, the shape operator of the space: |V| numbers in the unit
  /// of phi
  Eigen::VectorXd shape_operator(const Eigen::VectorXd& phi) const
  {
    return 2 / std::sqrt(m_system.areas().sum()) * response(phi);
  }

  /// d gamma / dt for rho = t phi at t = 0: minus the mean of phi
  double first_order(const Eigen::VectorXd& phi) const
  {
    return -m_system.areas().dot(phi) / m_system.areas().sum();
  }

  /// half the second derivative of gamma: -<phi, Re lambda-dot> / A, never positive
  double second_order(const Eigen::VectorXd& phi) const
  {
    return -m_system.areas().cwiseProduct(without_mean(phi)).dot(response(phi)) /
           m_system.areas().sum();
  }

 private:
  /// Re lambda-dot, where D lambda-dot = phi minus its mean
  Eigen::VectorXd response(const Eigen::VectorXd& phi) const
  {
    CGP::Quaternion_vector<double> image =
        CGP::averaging(m_mesh) * CGP::as_quaternions(without_mean(phi));
    const Eigen::VectorXd areas = CGP::face_areas(m_mesh);
    for (Eigen::Index f = 0; f < image.size(); ++f) image[f] *= areas[f];
    const CGP::Quaternion_vector<double> change =
        m_system.response(CGP::dirac(m_mesh).adjoint_times(image)).col(0);
    return CGP::components(change).row(0).transpose();
  }

  Eigen::VectorXd without_mean(const Eigen::VectorXd& phi) const
  {
    return phi.array() + first_order(phi);
  }

  const Mesh_view& m_mesh;
  CGP::internal::Dirac_system m_system;
};

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
  const Shape_space space(sphere);
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
    const Shape_space space(mesh);
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
  const Shape_space space(mesh);
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(mesh.size_of_vertices());
  const Eigen::VectorXd phi = rho_of_section_3_on_vertices(mesh);
  EXPECT_LT(space.shape_operator(one).norm(), 1e-12);
  EXPECT_NEAR(space.first_order(one), -1, 1e-14);
  const Eigen::VectorXd image = space.shape_operator(phi);
  EXPECT_LT((space.shape_operator(phi + one) - image).norm(), 1e-9 * image.norm());
  EXPECT_NEAR(CGP::vertex_areas(mesh).dot(image), 0, 1e-9);
  const Mesh_view large = scaled(mesh, 3);
  const Eigen::VectorXd same = Shape_space(large).shape_operator(phi / 3);
  EXPECT_LT((same - image / 3).norm(), 1e-8 * image.norm());
}

}  // namespace cgp_test::conformal_shape_space_tests
