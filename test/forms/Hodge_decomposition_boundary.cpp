// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests forms/Hodge_decomposition.h
#include <Conformal_geometry_processing/forms/Hodge_decomposition.h>
#include <Conformal_geometry_processing/operators/calculus.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "holed_surfaces.h"
#include "random_closed_forms.h"
#include "support/random.h"

namespace cgp_test::hodge_decomposition_boundary_tests {

/// Harmonic forms of Neumann type.

namespace CGP = Conformal_geometry_processing;

CGP::Harmonic_basis harmonic_basis_of(const Mesh_view& mesh)
{
  return CGP::Hodge_decomposition(mesh).harmonic_basis();
}

double greatest(const Eigen::MatrixXd& A)
{
  return A.size() == 0 ? 0 : A.cwiseAbs().maxCoeff();
}

void expect_harmonic_basis(const Mesh_view& mesh, int size)
{
  const Eigen::MatrixXd forms = harmonic_basis_of(mesh).one_forms;
  ASSERT_EQ(forms.cols(), size);
  const Eigen::VectorXd w = CGP::cotan_weights(mesh);
  EXPECT_LT(greatest(CGP::exterior_derivative_1(mesh) * forms), 1e-14);
  // At a boundary vertex this is the flow of the field out of the surface.
  EXPECT_LT(greatest(CGP::codifferential(mesh, w, forms)), 1e-14);
  const Eigen::MatrixXd gram = forms.transpose() * w.asDiagonal() * forms;
  EXPECT_LT(greatest(gram - Eigen::MatrixXd::Identity(size, size)), 1e-13);
}

/// of the fields in the faces at the boundary, the mean share that points out of the surface
double share_across_boundary(const Mesh_view& mesh, const Points& field)
{
  double sum = 0;
  int count = 0;
  for (int h = 0; h < mesh.size_of_halfedges(); ++h) {
    if (mesh.twin(h) >= 0) continue;
    const Eigen::Vector3d v = field.col(Mesh_view::face(h)).normalized();
    sum += v.cross(mesh.vector(h).normalized()).norm();
    ++count;
  }
  return sum / count;
}

TEST(Hodge_decomposition_with_boundary, finds_no_harmonic_forms_on_a_disk)
{
  for (const Mesh_view& mesh : {disk(4), grid(5, 3), cap_from_disk(disk(5), 2)})
    expect_harmonic_basis(mesh, 0);
}

TEST(Hodge_decomposition_with_boundary, finds_forms_that_are_closed_coclosed_and_orthonormal)
{
  expect_harmonic_basis(annulus(.4, 1, 24, 5), 1);
  expect_harmonic_basis(bent_annulus(36, 6), 1);
  expect_harmonic_basis(cylinder(1, 2, 16, 8), 1);
  expect_harmonic_basis(disk_with_three_holes(8), 3);
  expect_harmonic_basis(torus_with_hole(16, 10), 2);
}

// By the symmetry of the mesh the change of the angle is harmonic exactly.
TEST(Hodge_decomposition_with_boundary, finds_the_angle_of_an_annulus)
{
  std::vector<double> sizes, errors;
  for (const int n : {3, 6, 12}) {
    const Mesh_view mesh = annulus(.4, 1, 8 * n, n);
    Eigen::VectorXd angle(mesh.size_of_edges());
    for (int k = 0; k < angle.size(); ++k) {
      const Eigen::Vector3d a = mesh.position(mesh.ends(k)[0]), b = mesh.position(mesh.ends(k)[1]);
      angle[k] = std::atan2(a.cross(b).z(), a.dot(b));
    }
    const Eigen::VectorXd form = harmonic_basis_of(mesh).one_forms;
    const double along = form.dot(angle) / angle.squaredNorm();
    EXPECT_LT(greatest(form - along * angle), 1e-13);
    sizes.push_back(1. / n);
    errors.push_back(1 / (along * along) - 2 * pi * std::log(1 / .4));  // |d angle|^2
  }
  EXPECT_NEAR(slope(sizes, errors), 2, 0.1);
}

TEST(Hodge_decomposition_with_boundary, finds_fields_that_are_tangent_to_the_boundary)
{
  std::vector<double> sizes, shares;
  for (const int n : {4, 8, 16}) {
    const Mesh_view mesh = bent_annulus(8 * n, n);
    sizes.push_back(1. / n);
    shares.push_back(share_across_boundary(mesh, harmonic_basis_of(mesh).fields[0]));
  }
  EXPECT_LT(shares.back(), 0.05);
  EXPECT_NEAR(slope(sizes, shares), 1, 0.1);
}

TEST(Hodge_decomposition_with_boundary, splits_any_form_into_orthogonal_parts)
{
  for (const Mesh_view& mesh : {disk(5), bent_annulus(24, 4), disk_with_three_holes(6)}) {
    const Eigen::VectorXd w = CGP::cotan_weights(mesh);
    const Eigen::MatrixXd forms =
        random_numbers(2 * mesh.size_of_edges(), 5).reshaped(mesh.size_of_edges(), 2);
    const CGP::internal::Hodge_parts parts = CGP::Hodge_decomposition(mesh).decompose(forms);
    EXPECT_LT(greatest(parts.exact + parts.coexact + parts.harmonic - forms), 1e-14);
    EXPECT_LT(greatest(CGP::exterior_derivative_1(mesh) * parts.harmonic), 1e-13);
    EXPECT_LT(greatest(CGP::codifferential(mesh, w, parts.harmonic)), 1e-13);
    EXPECT_LT(greatest(CGP::codifferential(mesh, w, parts.coexact)), 1e-12);
    const auto product = [&](const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
      return greatest(a.transpose() * w.asDiagonal() * b) / forms.squaredNorm();
    };
    EXPECT_LT(product(parts.exact, parts.coexact), 1e-13);
    EXPECT_LT(product(parts.exact, parts.harmonic), 1e-13);
    EXPECT_LT(product(parts.coexact, parts.harmonic), 1e-13);
  }
}

TEST(Hodge_decomposition_with_boundary, finds_the_same_space_from_random_forms)
{
  const Mesh_view mesh = disk_with_three_holes(6);
  const Eigen::MatrixXd random = random_closed_forms(mesh, 3);
  ASSERT_EQ(random.cols(), 3);
  EXPECT_LT(greatest(CGP::exterior_derivative_1(mesh) * random), 1e-12);
  CGP::internal::Grounded_solver laplacian(CGP::vertex_graph(mesh));
  laplacian.factorize(CGP::cotan_laplacian(mesh));
  const CGP::Hodge_decomposition hodge(mesh, random, laplacian);
  const Eigen::MatrixXd found = hodge.harmonic_basis().one_forms;
  const CGP::Harmonic_basis expected = harmonic_basis_of(mesh);
  const Eigen::MatrixXd inside =
      expected.one_forms *
      (expected.one_forms.transpose() * CGP::cotan_weights(mesh).asDiagonal() * found);
  EXPECT_LT(greatest(found - inside), 1e-11);
}

}  // namespace cgp_test::hodge_decomposition_boundary_tests
