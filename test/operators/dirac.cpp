// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests operators/calculus.h
#include <Conformal_geometry_processing/operators/calculus.h>

#include <gtest/gtest.h>

#include "support/dense.h"
#include "support/meshes.h"

namespace cgp_test::dirac_tests {

namespace CGP = Conformal_geometry_processing;
using Q = Quaternion<double>;

std::vector<Mesh_view> sample_meshes()
{
  return {perturbed(icosphere(1), .2), perturbed(disk(3), .1), torus(2, 1, 6, 5), tetrahedron()};
}

/// areas and unit normals of the faces, not by the code under test
Eigen::VectorXd areas_of_faces(const Mesh_view& mesh)
{
  Eigen::VectorXd areas(mesh.size_of_faces());
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    areas[f] = area(Mesh_view(mesh.positions(), {mesh.corners(f)}));
  return areas;
}

Quaternion_matrix averages(const Mesh_view& mesh)
{
  Quaternion_matrix B = zero_matrix(mesh.size_of_faces(), mesh.size_of_vertices());
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    for (int v : mesh.corners(f)) B(f, v) = {1. / 3, 0, 0, 0};
  return B;
}

TEST(Dirac, of_a_triangle_has_minus_its_edges_over_twice_the_area)
{
  const Mesh_view mesh = single_triangle();
  const auto D = CGP::dirac(mesh);
  EXPECT_EQ(D.value(0, 0), (Q{0, 1, -.5, 0}));
  EXPECT_EQ(D.value(0, 1), (Q{0, 0, .5, 0}));
  EXPECT_EQ(D.value(0, 2), (Q{0, -1, 0, 0}));
}

TEST(Dirac, of_the_position_is_minus_twice_the_normal_on_every_face)
{
  for (const Mesh_view& mesh : sample_meshes()) {
    const auto Df = CGP::dirac(mesh) * imaginary_columns(mesh.positions());
    for (int f = 0; f < mesh.size_of_faces(); ++f) {
      const auto& v = mesh.corners(f);
      const Eigen::Vector3d N = (mesh.position(v[1]) - mesh.position(v[0]))
                                    .cross(mesh.position(v[2]) - mesh.position(v[0]))
                                    .normalized();
      EXPECT_LT(norm(Df[f] + 2. * CGP::imaginary(N)), 1e-12);
    }
  }
}

TEST(Dirac, is_the_normal_times_the_gradient_for_real_functions)
{
  // D a = N x grad a; in the plane z = 0 with a = 3x + 5y that is k (3i + 5j) = -5i + 3j.
  const Mesh_view mesh = disk(3);
  Quaternion_vector<double> a(mesh.size_of_vertices());
  for (int v = 0; v < a.size(); ++v)
    a[v] = {3 * mesh.position(v).x() + 5 * mesh.position(v).y(), 0, 0, 0};
  const auto Da = CGP::dirac(mesh) * a;
  for (int f = 0; f < mesh.size_of_faces(); ++f) EXPECT_LT(norm(Da[f] - Q{0, -5, 3, 0}), 1e-13);
}

TEST(Dirac, of_a_constant_is_zero)
{
  for (const Mesh_view& mesh : sample_meshes()) {
    const Quaternion_vector<double> constant =
        Quaternion_vector<double>::Constant(mesh.size_of_vertices(), Q{1, 2, 3, 4});
    EXPECT_LT(greatest_entry(CGP::dirac(mesh) * constant), 1e-12);
  }
}

TEST(Dirac, is_linear_from_the_right)
{
  const Mesh_view mesh = perturbed(icosphere(1), .2);
  const auto D = CGP::dirac(mesh);
  const Quaternion_vector<double> x = random_quaternions(42, 1), y = random_quaternions(42, 2);
  const Q q{.3, -2, 1, .7};
  const Quaternion_vector<double> Dx = D * x, Dy = D * y;
  Quaternion_vector<double> combination(42), wanted(80);
  for (int i = 0; i < 42; ++i) combination[i] = x[i] * q + y[i];
  for (int f = 0; f < 80; ++f) wanted[f] = Dx[f] * q + Dy[f];
  EXPECT_LT(greatest_difference(D * combination, wanted), 1e-13);
}

TEST(Dirac, is_self_adjoint_on_closed_surfaces)
{
  for (const Mesh_view& mesh : {perturbed(icosphere(1), .2), torus(2, 1, 6, 5), double_torus()}) {
    const Quaternion_matrix BMD =
        adjoint_product(averages(mesh), areas_of_faces(mesh), dense(CGP::dirac(mesh)));
    EXPECT_LT(hermitian_defect(BMD), 1e-14);
  }
}

TEST(Dirac, differs_from_its_adjoint_by_the_integral_along_the_boundary)
{
  // For an edge e from i to j of the boundary, the surface on its left: psi^ e phi with linear
  // psi and phi, that is e times (1/3 1/6; 1/6 1/3).
  const Mesh_view mesh = perturbed(disk(3), .1);
  const Quaternion_matrix BMD =
      adjoint_product(averages(mesh), areas_of_faces(mesh), dense(CGP::dirac(mesh)));
  Quaternion_matrix wanted = zero_matrix(mesh.size_of_vertices(), mesh.size_of_vertices());
  for (int h = 0; h < mesh.size_of_halfedges(); ++h) {
    if (mesh.twin(h) >= 0) continue;
    const int i = mesh.from(h), j = mesh.to(h);
    const Q e = CGP::imaginary(mesh.position(j) - mesh.position(i));
    wanted(i, i) += e / 3., wanted(j, j) += e / 3.;
    wanted(i, j) += e / 6., wanted(j, i) += e / 6.;
  }
  Quaternion_matrix defect = BMD;
  for (int i = 0; i < mesh.size_of_vertices(); ++i)
    for (int j = 0; j < mesh.size_of_vertices(); ++j) defect(i, j) -= conjugate(BMD(j, i));
  EXPECT_LT(relative_difference(defect, wanted), 1e-14);
}

TEST(Dirac, has_the_unit_of_one_over_length)
{
  const Mesh_view mesh = perturbed(icosphere(1), .2);
  const Mesh_view larger = scaled(mesh, 4);
  EXPECT_LT(relative_difference(dense(CGP::dirac(larger)),
                                Quaternion_matrix(.25 * dense(CGP::dirac(mesh)))),
            1e-15);
}

TEST(Dirac, turns_with_the_surface)
{
  // On the surface turned to conjugate(q) f q, the spinor conjugate(q) lambda has the image
  // conjugate(q) D lambda.
  const Q q = Random(3).quaternion() / 2., unit = q / norm(q);
  const Mesh_view mesh = perturbed(icosphere(1), .2);
  const Mesh_view turned =
      mapped(mesh, [&](const Eigen::Vector3d& p) { return CGP::spin(unit, p); });
  const Quaternion_vector<double> lambda = random_quaternions(42, 5);
  Quaternion_vector<double> spun(42), wanted = CGP::dirac(mesh) * lambda;
  for (int v = 0; v < 42; ++v) spun[v] = conjugate(unit) * lambda[v];
  for (int f = 0; f < 80; ++f) wanted[f] = conjugate(unit) * wanted[f];
  EXPECT_LT(greatest_difference(CGP::dirac(turned) * spun, wanted), 1e-12);
}

TEST(Dirac, changes_sign_with_the_orientation)
{
  const Mesh_view mesh = perturbed(icosphere(1), .2);
  const Mesh_view reversed = with_reversed_faces(mesh);
  EXPECT_LT(relative_difference(dense(CGP::dirac(reversed)),
                                Quaternion_matrix(-1. * dense(CGP::dirac(mesh)))),
            1e-15);
}

TEST(Averaging, takes_the_mean_of_the_corners)
{
  const Mesh_view mesh = disk(3);
  const Quaternion_vector<double> lambda = random_quaternions(mesh.size_of_vertices(), 2);
  const Quaternion_vector<double> B_lambda = CGP::averaging(mesh) * lambda;
  ASSERT_EQ(B_lambda.size(), mesh.size_of_faces());
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const auto& v = mesh.corners(f);
    EXPECT_LT(norm(B_lambda[f] - (lambda[v[0]] + lambda[v[1]] + lambda[v[2]]) / 3.), 1e-15);
  }
}

TEST(Averaging, keeps_constants)
{
  const Mesh_view mesh = icosphere(1);
  const Quaternion<double> q{1, -2, 3, .5};
  const Quaternion_vector<double> lambda = Quaternion_vector<double>::Constant(42, q);
  const Quaternion_vector<double> wanted = Quaternion_vector<double>::Constant(80, q);
  EXPECT_LT(greatest_difference(CGP::averaging(mesh) * lambda, wanted), 1e-15);
}

TEST(Averaging, takes_positions_to_centroids)
{
  const Mesh_view mesh = tetrahedron();  // the centroid of a face is minus a third of its opposite
  const Quaternion_vector<double> centroids =
      CGP::averaging(mesh) * imaginary_columns(mesh.positions());
  const Points wanted = -points({{-1, -1, 1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, 1}}) / 3;
  EXPECT_LT(greatest_difference(centroids, imaginary_columns(wanted)), 1e-15);
}

}  // namespace cgp_test::dirac_tests
