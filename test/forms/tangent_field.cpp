// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/forms/tangent_field.h
#include <Conformal_geometry_processing/forms/tangent_field.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace cgp_test::tangent_field_tests {

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

}  // namespace cgp_test::tangent_field_tests
