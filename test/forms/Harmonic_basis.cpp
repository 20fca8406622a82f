// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/forms/Harmonic_basis.h>
#include <Conformal_geometry_processing/forms/Hodge_decomposition.h>
#include <Conformal_geometry_processing/forms/tree_cotree.h>
#include <Conformal_geometry_processing/operators/calculus.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include "support/handlebodies.h"
#include "support/meshes.h"

#include <cmath>
#include <vector>

namespace cgp_test::harmonic_basis_tests {

namespace CGP = Conformal_geometry_processing;

Eigen::VectorXd differences(const Mesh_view& mesh, const Eigen::VectorXd& u)
{
  Eigen::VectorXd du(mesh.size_of_edges());
  for (int k = 0; k < mesh.size_of_edges(); ++k) du[k] = u[mesh.ends(k)[1]] - u[mesh.ends(k)[0]];
  return du;
}

TEST(Tangent_field, of_the_differential_of_a_linear_function_is_its_gradient)
{
  // (0,0), (2,0), (0,1) with u = 3x + 5y, in the plane z = 7
  const Mesh_view mesh(points({{0, 0, 7}, {2, 0, 7}, {0, 1, 7}}), {{0, 1, 2}});
  const Points v = CGP::tangent_field(mesh, Eigen::Vector3d(6, 5, -1));
  EXPECT_LT((v.col(0) - Eigen::Vector3d(3, 5, 0)).norm(), 1e-15);
}

TEST(Tangent_field, is_tangent_and_has_the_values_of_the_form_along_the_edges)
{
  const Mesh_view mesh = radially_perturbed(icosphere(2), 0.2);
  const Eigen::VectorXd du = differences(mesh, random_numbers(mesh.size_of_vertices(), 1));
  const Points v = CGP::tangent_field(mesh, du);
  for (int h = 0; h < mesh.size_of_halfedges(); ++h) {
    EXPECT_NEAR(v.col(Mesh_view::face(h)).dot(mesh.vector(h)), CGP::along_halfedge(mesh, du, h),
                1e-13);
    EXPECT_NEAR(v.col(h / 3).dot(mesh.double_area_vector(h / 3).normalized()), 0, 1e-13);
  }
}

TEST(Tangent_field, has_the_inner_product_of_the_forms)
{
  const Mesh_view mesh = radially_perturbed(icosphere(2), 0.2);
  const Eigen::VectorXd a = differences(mesh, random_numbers(mesh.size_of_vertices(), 1));
  const Eigen::VectorXd b = differences(mesh, random_numbers(mesh.size_of_vertices(), 2));
  const Points v = CGP::tangent_field(mesh, a), u = CGP::tangent_field(mesh, b);
  double sum = 0;
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    sum += mesh.double_area_vector(f).norm() / 2 * v.col(f).dot(u.col(f));
  const double expected = (CGP::cotan_weights(mesh).array() * a.array() * b.array()).sum();
  EXPECT_NEAR(sum, expected, 1e-12 * std::abs(a.dot(b)) + 1e-12);
}

TEST(Along_halfedge, changes_its_sign_with_the_direction)
{
  const Mesh_view mesh = tetrahedron();
  const Eigen::VectorXd form = random_numbers(6, 1);
  for (int h = 0; h < 12; ++h) {
    const double value = CGP::along_halfedge(mesh, form, h);
    EXPECT_EQ(value, -CGP::along_halfedge(mesh, form, mesh.twin(h)));
    EXPECT_EQ(value, mesh.from(h) < mesh.to(h) ? form[mesh.edge(h)] : -form[mesh.edge(h)]);
  }
}

CGP::Harmonic_basis harmonic_basis_of(const Mesh_view& mesh)
{
  return CGP::Hodge_decomposition(mesh).harmonic_basis();
}

double greatest(const Eigen::MatrixXd& A)
{
  return A.size() == 0 ? 0 : A.cwiseAbs().maxCoeff();
}

Eigen::MatrixXd gram_matrix(const Mesh_view& mesh, const Eigen::MatrixXd& forms)
{
  return forms.transpose() * CGP::cotan_weights(mesh).asDiagonal() * forms;
}

void expect_harmonic_and_orthonormal(const Mesh_view& mesh, const Eigen::MatrixXd& forms)
{
  const Eigen::VectorXd w = CGP::cotan_weights(mesh);
  EXPECT_LT(greatest(CGP::exterior_derivative_1(mesh) * forms), 1e-14);
  EXPECT_LT(greatest(CGP::codifferential(mesh, w, forms)), 1e-12);
  const auto n = forms.cols();
  EXPECT_LT(greatest(gram_matrix(mesh, forms) - Eigen::MatrixXd::Identity(n, n)), 1e-14);
}

void expect_fields_of_the_forms(const Mesh_view& mesh, const CGP::Harmonic_basis& basis)
{
  ASSERT_EQ(basis.fields.size(), std::size_t(basis.size()));
  for (int i = 0; i < basis.size(); ++i) {
    const Points& v = basis.fields[at(i)];
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    double squared_norm = 0;
    for (int f = 0; f < mesh.size_of_faces(); ++f) {
      const double A = mesh.double_area_vector(f).norm() / 2;
      mean += A * v.col(f);
      squared_norm += A * v.col(f).squaredNorm();
      const int h = 3 * f;
      const double value = (mesh.from(h) < mesh.to(h) ? 1 : -1) * basis.one_forms(mesh.edge(h), i);
      ASSERT_NEAR(v.col(f).dot(mesh.vector(h)), value, 1e-13);
    }
    EXPECT_LT(mean.norm(), 1e-13 * std::sqrt(area(mesh)));
    EXPECT_NEAR(squared_norm, 1, 1e-12);
  }
}

void expect_harmonic_basis(const Mesh_view& mesh, int genus)
{
  const CGP::Harmonic_basis basis = harmonic_basis_of(mesh);
  EXPECT_EQ(basis.genus(), genus);
  EXPECT_EQ(basis.size(), 2 * genus);
  expect_harmonic_and_orthonormal(mesh, basis.one_forms);
  expect_fields_of_the_forms(mesh, basis);
}

/// Distance of two spans, with bases that are orthonormal with weights w
double distance_of_spans(const Eigen::VectorXd& w, const Eigen::MatrixXd& a,
                         const Eigen::MatrixXd& b)
{
  return greatest(b - a * (a.transpose() * w.asDiagonal() * b));
}

TEST(Harmonic_basis, of_a_sphere_is_empty)
{
  for (const Mesh_view& mesh : {tetrahedron(), icosphere(2)}) expect_harmonic_basis(mesh, 0);
}

TEST(Harmonic_basis, is_closed_and_coclosed_and_orthonormal)
{
  expect_harmonic_basis(torus(2, 1, 3, 3), 1);
  expect_harmonic_basis(btorus(32), 1);
  expect_harmonic_basis(smooth_handlebody(2, 2), 2);
  expect_harmonic_basis(smooth_handlebody(3, 1), 3);
}

TEST(Harmonic_basis, minds_neither_right_angles_nor_thirty_one_handles)
{
  for (const int genus : {1, 2, 3, 31}) expect_harmonic_basis(holed_block(genus), genus);
  expect_harmonic_basis(smooth_handlebody(31, 1), 31);
}

TEST(Harmonic_basis, minds_no_negative_weights)
{
  const Mesh_view mesh = perturbed(btorus(24), 0.05);
  ASSERT_LT(CGP::cotan_weights(mesh).minCoeff(), -0.1);
  expect_harmonic_basis(mesh, 1);
}

// Rotations are isotopic to the identity: they map each class, and so each harmonic form, to
// itself.
TEST(Harmonic_basis, of_a_torus_of_revolution_is_constant_along_its_circles)
{
  const int m = 12, n = 9;
  const Mesh_view mesh = torus(2, 1, m, n);
  const CGP::Harmonic_basis basis = harmonic_basis_of(mesh);
  for (int h = 0; h < mesh.size_of_halfedges(); ++h) {
    const int next = (h + 6 * n) % mesh.size_of_halfedges();  // the halfedge one step further
    ASSERT_EQ(mesh.from(next), (mesh.from(h) + n) % (m * n));
    for (int i = 0; i < 2; ++i)
      EXPECT_NEAR(CGP::along_halfedge(mesh, basis.one_forms.col(i), h),
                  CGP::along_halfedge(mesh, basis.one_forms.col(i), next), 1e-13);
  }
}

TEST(Harmonic_basis, spans_the_same_space_in_any_numbering)
{
  const Mesh_view mesh = smooth_handlebody(2, 1);
  const std::vector<int> number = random_permutation(mesh.size_of_vertices(), 3);
  const Mesh_view other = renumbered(mesh, number);
  const Eigen::MatrixXd expected = harmonic_basis_of(mesh).one_forms;
  const Eigen::MatrixXd found = harmonic_basis_of(other).one_forms;
  Eigen::MatrixXd back(found.rows(), found.cols());  // faces keep their numbers, so halfedges do
  for (int h = 0; h < mesh.size_of_halfedges(); ++h)
    if (mesh.from(h) < mesh.to(h))
      for (Eigen::Index i = 0; i < found.cols(); ++i)
        back(mesh.edge(h), i) = CGP::along_halfedge(other, found.col(i), h);
  EXPECT_LT(distance_of_spans(CGP::cotan_weights(mesh), expected, back), 1e-12);
}

TEST(Harmonic_basis, does_not_change_with_the_scale_of_the_mesh)
{
  const Mesh_view mesh = btorus(12), large = scaled(mesh, 1024);
  const CGP::Harmonic_basis basis = harmonic_basis_of(mesh), other = harmonic_basis_of(large);
  EXPECT_EQ(other.one_forms, basis.one_forms);
  EXPECT_EQ(1024 * other.fields[1], basis.fields[1]);
}

TEST(Harmonic_basis, refuses_generators_that_are_not_independent)
{
  const Mesh_view mesh = btorus(12);
  Eigen::MatrixXd generators = CGP::closed_generators(mesh);
  generators.col(1) = -2 * generators.col(0);
  CGP::internal::Grounded_solver laplacian(CGP::vertex_graph(mesh));
  laplacian.factorize(CGP::cotan_laplacian(mesh));
  try {
    const CGP::Hodge_decomposition hodge(mesh, generators, laplacian);
    ADD_FAILURE() << "not refused";
  } catch (const CGP::Precondition_error& error) {
    EXPECT_NE(std::string(error.what()).find("not linearly independent"), std::string::npos);
  }
}

TEST(Harmonic_basis, refuses_more_forms_than_there_are_fields)
{
  const Mesh_view mesh = tetrahedron();
  Eigen::MatrixXd forms = random_numbers(6 * 13, 3).reshaped(6, 13);
  EXPECT_THROW(CGP::internal::orthonormalize_forms(mesh, forms), CGP::Precondition_error);
}

}  // namespace cgp_test::harmonic_basis_tests
