// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests operators/dirac_energy.h
#include <Conformal_geometry_processing/operators/calculus.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <gtest/gtest.h>

#include <vector>

#include "support/dense.h"
#include "support/meshes.h"

namespace cgp_test::dirac_forms_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Curvature_potential;

const Mesh_view bumps = radially_perturbed(icosphere(1), 0.2);

Quaternion_matrix random_columns(int columns)
{
  Quaternion_matrix V(bumps.size_of_vertices(), columns);
  for (int c = 0; c < columns; ++c)
    V.col(c) = random_quaternions(bumps.size_of_vertices(), at(c) + 10);
  return V;
}

/// V^H (B^H M_F A) V
Quaternion_matrix form(const Quaternion_matrix& V, const Quaternion_matrix& A)
{
  const Quaternion_matrix B = dense(CGP::averaging(bumps));
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(V.rows());
  const Quaternion_matrix matrix = adjoint_product(B, CGP::face_areas(bumps), A);
  Quaternion_matrix image = zero_matrix(static_cast<int>(V.rows()), static_cast<int>(V.cols()));
  for (Eigen::Index i = 0; i < V.rows(); ++i)
    for (Eigen::Index j = 0; j < V.rows(); ++j)
      for (Eigen::Index c = 0; c < V.cols(); ++c) image(i, c) += matrix(i, j) * V(j, c);
  return adjoint_product(V, one, image);
}

Quaternion_matrix hermitian_part(const Quaternion_matrix& A)
{
  Quaternion_matrix H = A;
  for (Eigen::Index i = 0; i < A.rows(); ++i)
    for (Eigen::Index j = 0; j < A.cols(); ++j) H(i, j) = (A(i, j) + conjugate(A(j, i))) / 2.;
  return H;
}

void expect_forms_of_the_matrices(const Curvature_potential& rho)
{
  const Quaternion_matrix V = random_columns(3);
  const CGP::internal::Dirac_forms forms = CGP::dirac_forms(bumps, rho, V);
  const Quaternion_matrix B = dense(CGP::averaging(bumps));
  const Quaternion_matrix A = dense(CGP::dirac(bumps)) - dense(CGP::potential_matrix(bumps, rho));
  EXPECT_LT(relative_difference(forms.dirac, hermitian_part(form(V, A))), 1e-13);
  EXPECT_LT(relative_difference(forms.mass, form(V, B)), 1e-13);
}

TEST(Dirac_forms, are_those_of_the_assembled_matrices_for_rho_on_faces)
{
  expect_forms_of_the_matrices(
      Curvature_potential::on_faces(random_numbers(bumps.size_of_faces(), 1)));
}

TEST(Dirac_forms, are_those_of_the_assembled_matrices_for_rho_on_vertices)
{
  expect_forms_of_the_matrices(
      Curvature_potential::on_vertices(random_numbers(bumps.size_of_vertices(), 2)));
}

TEST(Apply_dirac_form, is_the_operator_of_the_form)
{
  const Quaternion_matrix V = random_columns(2);
  for (const auto& rho :
       {Curvature_potential::on_faces(random_numbers(bumps.size_of_faces(), 3)),
        Curvature_potential::on_vertices(random_numbers(bumps.size_of_vertices(), 4))}) {
    const CGP::internal::Dirac_forms forms = CGP::dirac_forms(bumps, rho, V);
    for (int c = 0; c < 2; ++c) {
      const Quaternion_vector<double> image = CGP::apply_dirac_form(bumps, rho, V.col(c));
      for (int r = 0; r < 2; ++r)
        EXPECT_LT(norm(CGP::inner_product(V.col(r), image) - forms.dirac(r, c)), 1e-13);
    }
  }
}

TEST(Dirac_quotient, of_constants_is_minus_the_constant_rho)
{
  const Quaternion_vector<double> q =
      Quaternion_vector<double>::Constant(bumps.size_of_vertices(), {0.3, -2, 0.5, 1});
  const auto on_faces = Eigen::VectorXd::Constant(bumps.size_of_faces(), 0.75);
  const auto on_vertices = Eigen::VectorXd::Constant(bumps.size_of_vertices(), 0.75);
  EXPECT_NEAR(CGP::dirac_quotient(bumps, Curvature_potential::on_faces(on_faces), q), -0.75, 1e-14);
  EXPECT_NEAR(CGP::dirac_quotient(bumps, Curvature_potential::on_vertices(on_vertices), q), -0.75,
              1e-14);
}

TEST(Dirac_quotient, of_the_normal_of_the_unit_sphere_converges_to_minus_two)
{
  std::vector<double> h, error;
  for (int level = 1; level <= 3; ++level) {
    const Mesh_view sphere = icosphere(level);
    const auto none = Curvature_potential::on_faces(Eigen::VectorXd::Zero(sphere.size_of_faces()));
    const double quotient =
        CGP::dirac_quotient(sphere, none, imaginary_columns(sphere.positions()));
    h.push_back(mean_edge_length(sphere));
    error.push_back(quotient + 2);
  }
  EXPECT_LT(std::abs(error.back()), 0.02);
  EXPECT_GT(slope(h, error), 1.9);
}

TEST(Dirac_quotient, does_not_see_a_right_factor)
{
  const auto rho = Curvature_potential::on_faces(random_numbers(bumps.size_of_faces(), 3));
  const Quaternion_vector<double> lambda = random_columns(1);
  Quaternion_vector<double> turned = lambda;
  for (auto& l : turned) l = l * Quaternion<double>{1, -2, 0.5, 3};
  EXPECT_NEAR(CGP::dirac_quotient(bumps, rho, turned), CGP::dirac_quotient(bumps, rho, lambda),
              1e-12);
}

TEST(Dirac_misfit, is_the_root_of_the_quotient_of_the_energy_and_the_areas)
{
  const Quaternion_vector<double> v = random_columns(1);
  for (const auto& rho :
       {Curvature_potential::on_faces(random_numbers(bumps.size_of_faces(), 5)),
        Curvature_potential::on_vertices(random_numbers(bumps.size_of_vertices(), 6))}) {
    const double energy = CGP::inner_product(v, CGP::dirac_energy(bumps, rho) * v).w;
    const double mass = CGP::inner_product(v, CGP::vertex_areas(bumps), v).w;
    EXPECT_NEAR(CGP::dirac_misfit(bumps, rho, v), std::sqrt(energy / mass), 1e-12);
  }
}

TEST(Dirac_misfit, has_all_digits_where_nothing_is_left)
{
  const Quaternion_vector<double> one =
      Quaternion_vector<double>::Constant(bumps.size_of_vertices(), {1, 0, 0, 0});
  const auto none = Curvature_potential::on_faces(Eigen::VectorXd::Zero(bumps.size_of_faces()));
  EXPECT_LT(CGP::dirac_misfit(bumps, none, one), 1e-14);
}

TEST(Potential_quotient, is_a_mean_of_rho_by_the_squares_of_averages)
{
  const Quaternion_vector<double> lambda = random_columns(1);
  const auto rho = Curvature_potential::on_faces(random_numbers(bumps.size_of_faces(), 3));
  double sum = 0, mass = 0;
  for (int f = 0; f < bumps.size_of_faces(); ++f) {
    const auto& v = bumps.corners(f);
    const double weight = bumps.double_area_vector(f).norm() *
                          CGP::squared_norm(lambda[v[0]] + lambda[v[1]] + lambda[v[2]]);
    sum += weight * rho.values[f];
    mass += weight;
  }
  EXPECT_NEAR(CGP::potential_quotient(bumps, rho, lambda), sum / mass, 1e-13);
}

TEST(Potential_quotient, is_what_rho_takes_from_the_dirac_quotient)
{
  const Quaternion_vector<double> lambda = random_columns(1);
  const auto none = CGP::no_potential(bumps);
  for (const auto& rho :
       {Curvature_potential::on_faces(random_numbers(bumps.size_of_faces(), 3)),
        Curvature_potential::on_vertices(random_numbers(bumps.size_of_vertices(), 3))})
    EXPECT_NEAR(CGP::potential_quotient(bumps, rho, lambda),
                CGP::dirac_quotient(bumps, none, lambda) - CGP::dirac_quotient(bumps, rho, lambda),
                1e-12);
}

}  // namespace cgp_test::dirac_forms_tests
