// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/calculus.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>

#include <gtest/gtest.h>

#include <Eigen/Core>

#include "support/decompositions.h"
#include "support/dense.h"
#include "support/meshes.h"

namespace cgp_test::dirac_energy_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Curvature_potential;
using Q = Quaternion<double>;

std::vector<Mesh_view> sample_meshes()
{
  return {perturbed(icosphere(1), .2), perturbed(disk(3), .1), torus(2, 1, 6, 5),
          annulus(1, 2, 6, 2), renumbered(perturbed(icosphere(1), .1), random_permutation(42, 3))};
}

std::vector<Curvature_potential> sample_potentials(const Mesh_view& mesh)
{
  return {Curvature_potential::on_faces(random_numbers(mesh.size_of_faces(), 8)),
          Curvature_potential::on_vertices(random_numbers(mesh.size_of_vertices(), 9))};
}

Curvature_potential zero_potential(const Mesh_view& mesh)
{
  return Curvature_potential::on_faces(Eigen::VectorXd::Zero(mesh.size_of_faces()));
}

void expect_entries(const CGP::Hermitian_sparse_matrix<Q>& X, const Q (&wanted)[6])
{
  int k = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j, ++k) {
      EXPECT_LT(norm(X.coefficient(i, j) - wanted[k]), 1e-15) << i << " " << j;
      EXPECT_LT(norm(X.coefficient(j, i) - conjugate(wanted[k])), 1e-15) << i << " " << j;
    }
}

TEST(Dirac_energy, of_a_triangle_with_rho_on_its_face_is_as_computed_by_hand)
{
  const auto rho = Curvature_potential::on_faces(Eigen::VectorXd::Constant(1, .6));
  const Q wanted[] = {{1.29, 0, 0, 0}, {-.21, .2, -.2, -.5}, {-.96, .4, -.1, .5},
                      {.29, 0, 0, 0},  {.04, .2, .1, -.5},   {1.04, 0, 0, 0}};
  expect_entries(CGP::dirac_energy(single_triangle(), rho), wanted);
}

TEST(Dirac_energy, of_a_triangle_with_rho_on_its_vertices_is_as_computed_by_hand)
{
  const auto rho = Curvature_potential::on_vertices(Eigen::Vector3d(.3, .6, -.9));
  const Q wanted[] = {{1.26, 0, 0, 0}, {-.23, .2, -.15, -.5}, {-1.03, -.2, .15, .5},
                      {.29, 0, 0, 0},  {-.06, .2, -.15, -.5}, {1.09, 0, 0, 0}};
  expect_entries(CGP::dirac_energy(single_triangle(), rho), wanted);
}

TEST(Dirac_energy, is_the_square_of_D_minus_R)
{
  for (const Mesh_view& mesh : sample_meshes())
    for (const Curvature_potential& rho : sample_potentials(mesh)) {
      const Quaternion_matrix A = dense(CGP::dirac(mesh) - CGP::potential_matrix(mesh, rho));
      const Quaternion_matrix wanted = adjoint_product(A, CGP::face_areas(mesh), A);
      EXPECT_LT(relative_difference(dense(CGP::dirac_energy(mesh, rho)), wanted), 1e-14);
    }
}

TEST(Dirac_energy, without_rho_has_the_cotan_laplacian_as_its_real_part)
{
  for (const Mesh_view& mesh : sample_meshes()) {
    const Eigen::MatrixXd L = dense(CGP::cotan_laplacian(mesh));
    const Eigen::MatrixXd real = real_part(dense(CGP::dirac_energy(mesh, zero_potential(mesh))));
    EXPECT_LT((real - L).cwiseAbs().maxCoeff(), 1e-14 * L.cwiseAbs().maxCoeff());
  }
}

TEST(Dirac_energy, without_rho_has_half_the_jumps_of_the_normals_as_its_imaginary_part)
{
  const Mesh_view mesh = perturbed(icosphere(1), .2);
  const auto X = CGP::dirac_energy(mesh, zero_potential(mesh));
  for (int h = 0; h < mesh.size_of_halfedges(); ++h) {
    const auto normal = [&](int g) { return mesh.double_area_vector(g / 3).normalized(); };
    const Eigen::Vector3d wanted = -(normal(h) - normal(mesh.twin(h))) / 2;
    const Q entry = X.coefficient(mesh.from(h), mesh.to(h));
    EXPECT_LT((CGP::imaginary_part(entry) - wanted).norm(), 1e-13);
  }
}

TEST(Dirac_energy, without_rho_vanishes_on_constants_alone)
{
  for (const Mesh_view& mesh : {perturbed(icosphere(1), .2), torus(2, 1, 6, 5)}) {
    const Quaternion_matrix X = dense(CGP::dirac_energy(mesh, zero_potential(mesh)));
    const Quaternion_matrix constant =
        Quaternion_matrix::Constant(mesh.size_of_vertices(), 1, Q{1, 2, 3, 4});
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(mesh.size_of_vertices());
    EXPECT_LT(greatest_entry(adjoint_product(X, ones, constant)), 1e-12);
    const Eigen::VectorXd mu = symmetric_eigenvalues(real_form(X));
    EXPECT_LT(mu.head(4).cwiseAbs().maxCoeff(), 1e-13);  // one quaternion is four numbers
    EXPECT_GT(mu[4], 1e-3);
  }
}

TEST(Dirac_energy, is_positive_semidefinite_for_any_rho)
{
  const Mesh_view mesh = perturbed(icosphere(1), .2);
  for (const Curvature_potential& rho : sample_potentials(mesh)) {
    const Eigen::MatrixXd X = real_form(dense(CGP::dirac_energy(mesh, rho)));
    EXPECT_LT((X - X.transpose()).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_GT(symmetric_eigenvalues(X)[0], -1e-13);
  }
}

TEST(Dirac_energy, of_a_constant_is_the_integral_of_rho_squared)
{
  // (D - R) 1 = -rho: with rho on faces, 1^H X 1 is the sum of A rho^2.
  const Mesh_view mesh = perturbed(icosphere(1), .2);
  const Eigen::VectorXd rho = random_numbers(80, 3);
  const auto X = CGP::dirac_energy(mesh, Curvature_potential::on_faces(rho));
  const Quaternion_vector<double> one = Quaternion_vector<double>::Constant(42, Q{1, 0, 0, 0});
  double wanted = 0;
  for (int f = 0; f < 80; ++f) wanted += mesh.double_area_vector(f).norm() / 2 * rho[f] * rho[f];
  const Q energy = CGP::inner_product(one, X * one);
  EXPECT_LT(norm(energy - Q{wanted, 0, 0, 0}), 1e-12);
}

TEST(Dirac_energy, does_not_depend_on_the_unit_of_length)
{
  const Mesh_view mesh = perturbed(icosphere(1), .2), larger = scaled(mesh, 4);
  for (Curvature_potential rho : sample_potentials(mesh)) {
    const Quaternion_matrix wanted = dense(CGP::dirac_energy(mesh, rho));
    rho.values /= 4;
    EXPECT_LT(relative_difference(dense(CGP::dirac_energy(larger, rho)), wanted), 1e-15);
  }
}

TEST(Dirac_energy, is_permuted_with_the_vertices)
{
  const Mesh_view mesh = perturbed(icosphere(1), .2);
  const std::vector<int> number = random_permutation(42, 4);
  const Eigen::VectorXd rho = random_numbers(42, 2);
  Eigen::VectorXd new_rho(42);
  for (int v = 0; v < 42; ++v) new_rho[number[at(v)]] = rho[v];
  const auto X = CGP::dirac_energy(mesh, Curvature_potential::on_vertices(rho));
  const auto Y =
      CGP::dirac_energy(renumbered(mesh, number), Curvature_potential::on_vertices(new_rho));
  for (int i = 0; i < 42; ++i)
    for (int j = 0; j < 42; ++j)
      EXPECT_LT(norm(Y.coefficient(number[at(i)], number[at(j)]) - X.coefficient(i, j)), 1e-14);
}

TEST(Dirac_energy, turns_with_the_surface)
{
  // X becomes conjugate(q) X q, entry by entry.
  const Q random = Random(3).quaternion(), q = random / norm(random);
  const Mesh_view mesh = perturbed(icosphere(1), .2);
  const Mesh_view turned = mapped(mesh, [&](const Eigen::Vector3d& p) { return CGP::spin(q, p); });
  for (const Curvature_potential& rho : sample_potentials(mesh)) {
    Quaternion_matrix wanted = dense(CGP::dirac_energy(mesh, rho));
    for (Eigen::Index k = 0; k < wanted.size(); ++k)
      wanted.data()[k] = conjugate(q) * wanted.data()[k] * q;
    EXPECT_LT(relative_difference(dense(CGP::dirac_energy(turned, rho)), wanted), 1e-13);
  }
}

TEST(Assemble_dirac_energy, replaces_what_was_there)
{
  const Mesh_view mesh = perturbed(icosphere(1), .2);
  const auto rho = sample_potentials(mesh);
  CGP::Hermitian_sparse_matrix<Q> X(CGP::vertex_graph(mesh));
  CGP::assemble_dirac_energy(mesh, rho[0], X);
  CGP::assemble_dirac_energy(mesh, rho[1], X);
  EXPECT_EQ(relative_difference(dense(X), dense(CGP::dirac_energy(mesh, rho[1]))), 0);
}

TEST(Dirac_form, is_the_average_times_D_minus_R)
{
  for (const Mesh_view& mesh : {perturbed(icosphere(1), .2), torus(2, 1, 6, 5), double_torus()}) {
    const Curvature_potential rho = sample_potentials(mesh)[0];
    const Quaternion_matrix A = dense(CGP::dirac(mesh) - CGP::potential_matrix(mesh, rho));
    const Quaternion_matrix wanted =
        adjoint_product(dense(CGP::averaging(mesh)), CGP::face_areas(mesh), A);
    EXPECT_LT(hermitian_defect(wanted), 1e-14);
    EXPECT_LT(relative_difference(dense(CGP::dirac_form(mesh, rho)), wanted), 1e-14);
  }
}

TEST(Dirac_form, would_not_be_hermitian_with_rho_on_vertices)
{
  const Mesh_view mesh = icosphere(2);
  const auto rho = Curvature_potential::on_vertices(rho_of_section_3_on_vertices(mesh));
  const Quaternion_matrix A = dense(CGP::dirac(mesh) - CGP::potential_matrix(mesh, rho));
  EXPECT_GT(
      hermitian_defect(adjoint_product(dense(CGP::averaging(mesh)), CGP::face_areas(mesh), A)),
      .01);
}

TEST(Dirac_form, gives_minus_the_integral_of_rho_on_constants)
{
  const Mesh_view mesh = perturbed(icosphere(1), .2);
  const Eigen::VectorXd rho = random_numbers(80, 3);
  const Quaternion_vector<double> one = Quaternion_vector<double>::Constant(42, Q{1, 0, 0, 0});
  const auto K = CGP::dirac_form(mesh, Curvature_potential::on_faces(rho));
  double wanted = 0;
  for (int f = 0; f < 80; ++f) wanted -= mesh.double_area_vector(f).norm() / 2 * rho[f];
  EXPECT_LT(norm(CGP::inner_product(one, K * one) - Q{wanted, 0, 0, 0}), 1e-13);
}

TEST(Dirac_form, grows_with_the_unit_of_length)
{
  const Mesh_view mesh = perturbed(icosphere(1), .2);
  const Eigen::VectorXd rho = random_numbers(80, 3);
  const Quaternion_matrix K = dense(CGP::dirac_form(mesh, Curvature_potential::on_faces(rho)));
  const Quaternion_matrix larger =
      dense(CGP::dirac_form(scaled(mesh, 4), Curvature_potential::on_faces(rho / 4)));
  EXPECT_LT(relative_difference(larger, Quaternion_matrix(4. * K)), 1e-15);
}

}  // namespace cgp_test::dirac_energy_tests
