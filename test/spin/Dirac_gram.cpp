// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/follow_branch.h
#include <Conformal_geometry_processing/mesh/Delaunay_view.h>
#include <Conformal_geometry_processing/operators/calculus.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/follow_branch.h>
#include <Quaternionic_linear_algebra/dense/block_operators.h>

#include <gtest/gtest.h>

#include <utility>

#include "support/dense.h"
#include "support/meshes.h"
#include "support/thin_faces.h"

namespace cgp_test::dirac_gram_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Curvature_potential;
using CGP::internal::Dirac_gram;

/// points (t, sigma); the first and the last let a sign or a factor of the mixed products show
const std::pair<double, double> points_of_test[] = {{0, 0}, {1, 0}, {0, .8}, {.3, -.7}, {-2, 1.5}};

Curvature_potential random_potential(const Mesh_view& mesh, Curvature_potential::On on)
{
  const bool on_faces = on == Curvature_potential::On::faces;
  return {on, 2 * random_numbers(on_faces ? mesh.size_of_faces() : mesh.size_of_vertices(), 7)};
}

const auto both = {Curvature_potential::On::vertices, Curvature_potential::On::faces};

/// t rho + sigma
Curvature_potential shifted(const Curvature_potential& rho, double t, double sigma)
{
  return {rho.on, (t * rho.values.array() + sigma).matrix()};
}

Quaternion_matrix random_columns(int rows, int columns)
{
  Quaternion_matrix V(rows, columns);
  for (int c = 0; c < columns; ++c) V.col(c) = random_quaternions(rows, at(c) + 10);
  return V;
}

Quaternion_matrix product(const Quaternion_matrix& A, const Quaternion_matrix& V)
{
  return CGP::combination(A, V);
}

/// D - t R - sigma B
Quaternion_matrix dense_operator(const Mesh_view& mesh, const Curvature_potential& rho, double t,
                                 double sigma)
{
  Quaternion_matrix A = dense(CGP::dirac(mesh));
  const Quaternion_matrix R = dense(CGP::potential_matrix(mesh, rho)),
                          B = dense(CGP::averaging(mesh));
  for (Eigen::Index k = 0; k < A.size(); ++k)
    A.data()[k] = A.data()[k] - t * R.data()[k] - sigma * B.data()[k];
  return A;
}

/// Re <B v, M_F (D - t R) v> / <B v, M_F B v>
double dense_quotient(const Mesh_view& mesh, const Curvature_potential& rho, double t,
                      const Quaternion_matrix& v)
{
  const Quaternion_matrix b = product(dense(CGP::averaging(mesh)), v),
                          a = product(dense_operator(mesh, rho, t, 0), v);
  const Eigen::VectorXd areas = CGP::face_areas(mesh);
  return adjoint_product(b, areas, a)(0, 0).w / adjoint_product(b, areas, b)(0, 0).w;
}

/// the same numbers as functions that assemble X or go through the sheets for each potential
void expect_forms_of(const CGP::Surface_ref& surface, const Curvature_potential& rho, int columns)
{
  const Quaternion_matrix V = random_columns(surface.size_of_vertices(), columns);
  const Dirac_gram gram(surface, rho, V);
  const Quaternion_vector<double> c = random_quaternions(columns, 3);
  for (const auto& [t, sigma] : points_of_test) {
    const auto X = CGP::dirac_energy(surface, shifted(rho, t, sigma));
    const Quaternion_matrix expected = CGP::gram_matrix(V, CGP::block_operator(X)(V));
    EXPECT_LT(relative_difference(gram.energy(t, sigma), expected), 1e-12) << t << ' ' << sigma;
    EXPECT_NEAR(gram.quotient(t, c),
                CGP::dirac_quotient(surface, shifted(rho, t, 0), product(V, c).col(0)), 1e-12);
  }
}

TEST(Dirac_gram, has_the_energies_and_quotients_of_the_dense_matrices)
{
  const Mesh_view mesh = radially_perturbed(icosphere(1), 0.2);
  const Quaternion_matrix V = random_columns(mesh.size_of_vertices(), 3);
  const Quaternion_vector<double> c = random_quaternions(3, 1);
  for (const auto on : both) {
    const Curvature_potential rho = random_potential(mesh, on);
    const Dirac_gram gram(mesh, rho, V);
    ASSERT_EQ(gram.size_of_vectors(), 3);
    for (const auto& [t, sigma] : points_of_test) {
      const Quaternion_matrix AV = product(dense_operator(mesh, rho, t, sigma), V);
      const Quaternion_matrix expected = adjoint_product(AV, CGP::face_areas(mesh), AV);
      EXPECT_LT(relative_difference(gram.energy(t, sigma), expected), 1e-13) << t << ' ' << sigma;
      EXPECT_NEAR(gram.quotient(t, c), dense_quotient(mesh, rho, t, product(V, c)), 1e-13);
    }
  }
}

TEST(Dirac_gram, adds_vectors_and_forgets_early_ones)
{
  const Mesh_view mesh = radially_perturbed(icosphere(2), 0.2);
  const Quaternion_matrix V = random_columns(mesh.size_of_vertices(), 6);
  Quaternion_matrix kept(V.rows(), 3);
  kept << V.col(0), V.rightCols(2);
  for (const auto on : both) {
    const Curvature_potential rho = random_potential(mesh, on);
    Dirac_gram gram;
    EXPECT_EQ(gram.size_of_vectors(), 0);
    for (const int columns : {1, 4, 4, 6}) gram.extend(mesh, rho, V.leftCols(columns));
    const Dirac_gram all(mesh, rho, V), last(mesh, rho, kept);
    EXPECT_LT(relative_difference(gram.energy(.3, -.7), all.energy(.3, -.7)), 1e-14);
    gram.forget_all_but(5);
    EXPECT_EQ(gram.size_of_vectors(), 6);
    gram.forget_all_but(2);
    EXPECT_LT(relative_difference(gram.energy(.3, -.7), last.energy(.3, -.7)), 1e-14);
  }
}

TEST(Dirac_gram, begins_at_a_base)
{
  const Mesh_view mesh = radially_perturbed(icosphere(2), 0.2);
  const Quaternion_matrix V = random_columns(mesh.size_of_vertices(), 3);
  const Quaternion_vector<double> c = random_quaternions(3, 1);
  for (const auto on : both) {
    const Curvature_potential rho = random_potential(mesh, on);
    const Curvature_potential base{on, rho.values.reverse()};
    const Dirac_gram gram(mesh, base, rho, V);
    for (const auto& [t, sigma] : points_of_test) {
      const Curvature_potential there{on, base.values + shifted(rho, t, 0).values};
      const auto X = CGP::dirac_energy(mesh, shifted(there, 1, sigma));
      const Quaternion_matrix expected = CGP::gram_matrix(V, CGP::block_operator(X)(V));
      EXPECT_LT(relative_difference(gram.energy(t, sigma), expected), 1e-12) << t << ' ' << sigma;
      EXPECT_NEAR(gram.quotient(t, c), CGP::dirac_quotient(mesh, there, product(V, c).col(0)),
                  1e-12);
    }
  }
}

TEST(Dirac_gram, is_that_of_the_sheets_on_every_surface)
{
  const Mesh_view clean = bumpy_sphere(1), mesh = spoilt(clean), bounded = disk(4);
  const CGP::Delaunay_view view(mesh);
  ASSERT_GT(view.number_of_flips(), 0);
  for (const auto on : both) {
    expect_forms_of(clean, random_potential(clean, on), 4);
    expect_forms_of(view, random_potential(mesh, on), 4);
    expect_forms_of(bounded, random_potential(bounded, on), 2);
  }
}

// The sheets are gone through in blocks of 256: the last one is not full.
TEST(Dirac_gram, is_that_of_all_sheets_of_a_mesh_of_many_blocks)
{
  const Mesh_view mesh = geodesic_sphere(6);
  ASSERT_NE(mesh.size_of_faces() % 256, 0);
  for (const auto on : both) expect_forms_of(mesh, random_potential(mesh, on), 1);
}

TEST(Dirac_gram, has_hermitian_energies_without_negative_eigenvalues)
{
  const Mesh_view mesh = bumpy_sphere(1);
  const Curvature_potential rho = random_potential(mesh, Curvature_potential::On::vertices);
  const Dirac_gram gram(mesh, rho, random_columns(mesh.size_of_vertices(), 4));
  for (const auto& [t, sigma] : points_of_test) {
    const Quaternion_matrix E = gram.energy(t, sigma);
    EXPECT_LT(hermitian_defect(E), 1e-15);
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      const Quaternion_vector<double> c = random_quaternions(4, seed);
      EXPECT_GT(CGP::inner_product(c, product(E, c).col(0)).w, 0);
    }
  }
}

TEST(Dirac_gram, does_not_tell_rho_plus_a_constant_from_another_shift)
{
  const Mesh_view mesh = bumpy_sphere(1);
  const Quaternion_matrix V = random_columns(mesh.size_of_vertices(), 3);
  const Quaternion_vector<double> c = random_quaternions(3, 2);
  for (const auto on : both) {
    const Curvature_potential rho = random_potential(mesh, on);
    const Dirac_gram gram(mesh, rho, V), other(mesh, shifted(rho, 1, 3), V);
    EXPECT_LT(relative_difference(other.energy(.5, -1), gram.energy(.5, .5)), 1e-13);
    EXPECT_NEAR(other.quotient(.5, c), gram.quotient(.5, c) - 1.5, 1e-13);
  }
}

TEST(Dirac_gram, has_a_quotient_that_does_not_see_a_right_factor)
{
  const Mesh_view mesh = bumpy_sphere(1);
  const Curvature_potential rho = random_potential(mesh, Curvature_potential::On::faces);
  const Dirac_gram gram(mesh, rho, random_columns(mesh.size_of_vertices(), 3));
  const Quaternion_vector<double> c = random_quaternions(3, 4);
  Quaternion_vector<double> turned = c;
  for (auto& q : turned) q = q * Quaternion<double>{1, -2, 0.5, 3};
  EXPECT_NEAR(gram.quotient(.7, turned), gram.quotient(.7, c), 1e-13);
}

}  // namespace cgp_test::dirac_gram_tests
