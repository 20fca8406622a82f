// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/operators/dirac_energy.h
// Tests include/Conformal_geometry_processing/operators/dirac_energy.h
// Tests include/Conformal_geometry_processing/operators/cotan_laplacian.h
#include <Conformal_geometry_processing/mesh/Delaunay_view.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>

#include "support/bounded_meshes.h"
#include "support/decompositions.h"
#include "support/dense.h"
#include "support/meshes.h"
#include "support/thin_faces.h"

namespace cgp_test::delaunay_operators_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Curvature_potential;
using CGP::Delaunay_view;

using Energy = CGP::Hermitian_sparse_matrix<Quaternion<double>>;

/// ascending, of X v = mu M v: each four times
Eigen::VectorXd eigenvalues(const Energy& X, const Eigen::VectorXd& areas)
{
  Eigen::VectorXd root(4 * areas.size());
  for (Eigen::Index i = 0; i < root.size(); ++i) root[i] = 1 / std::sqrt(areas[i / 4]);
  const Eigen::MatrixXd A = root.asDiagonal() * real_form(dense(X)) * root.asDiagonal();
  return symmetric_eigenvalues(A);
}

Eigen::VectorXd eigenvalues(const Energy& X)
{
  return eigenvalues(X, Eigen::VectorXd::Ones(X.size()));
}

Curvature_potential random_potential(const Mesh_view& mesh, Curvature_potential::On on)
{
  const bool on_faces = on == Curvature_potential::On::faces;
  return {on, 3 * random_numbers(on_faces ? mesh.size_of_faces() : mesh.size_of_vertices(), 7)};
}

const auto both = {Curvature_potential::On::vertices, Curvature_potential::On::faces};

Mesh_view stretched_sphere()
{
  return mapped(bumpy_sphere(1),
                [](const Eigen::Vector3d& p) { return Eigen::Vector3d(p.x(), 5 * p.y(), p.z()); });
}

TEST(Delaunay_operators, are_those_of_the_mesh_where_that_is_Delaunay)
{
  for (const Mesh_view& mesh : {bumpy_sphere(2), torus(2, 1, 16, 8)}) {
    const Delaunay_view view(mesh);
    EXPECT_EQ(*vertex_graph(view), *vertex_graph(mesh));
    EXPECT_LT((vertex_areas(view) - vertex_areas(mesh)).norm(), 1e-14);
    const Eigen::MatrixXd L = dense(cotan_laplacian(view, vertex_graph(view)));
    EXPECT_LT((L - dense(CGP::cotan_laplacian(mesh))).cwiseAbs().maxCoeff(), 1e-13);
    Quaternion_matrix vectors(mesh.size_of_vertices(), 2);
    vectors << random_quaternions(mesh.size_of_vertices(), 1),
        random_quaternions(mesh.size_of_vertices(), 2);
    for (const auto on : both) {
      const Curvature_potential rho = random_potential(mesh, on);
      EXPECT_LT(relative_difference(dense(dirac_energy(view, rho)), dense(dirac_energy(mesh, rho))),
                1e-14);
      const CGP::internal::Dirac_forms forms = dirac_forms(view, rho, vectors),
                                       expected = dirac_forms(mesh, rho, vectors);
      EXPECT_LT(relative_difference(forms.dirac, expected.dirac), 1e-13);
      EXPECT_LT(relative_difference(forms.mass, expected.mass), 1e-13);
      const Quaternion_vector<double> v = vectors.col(0);
      EXPECT_NEAR(dirac_quotient(view, rho, v), dirac_quotient(mesh, rho, v), 1e-13);
      EXPECT_NEAR(dirac_misfit(view, rho, v), dirac_misfit(mesh, rho, v), 1e-12);
      EXPECT_LT(relative_difference(apply_dirac_form(view, rho, v), apply_dirac_form(mesh, rho, v)),
                1e-13);
    }
  }
}

TEST(Delaunay_operators, are_bounded_however_thin_the_faces)
{
  for (const Mesh_view& clean : {bumpy_sphere(1), torus(1, .4, 12, 6), disk(4)}) {
    const bool is_closed = CGP::boundary_loops(clean).empty();
    const double norm = eigenvalues(dirac_energy(clean, CGP::no_potential(clean))).maxCoeff();
    const double bound = norm < 6 ? 10 : 1.5 * norm;  // right angles have more than equal ones
    Eigen::VectorXd low;
    for (const double height : {1e-3, 1e-6, 1e-9, 0.}) {
      const Mesh_view mesh = with_thin_faces(clean, height);
      const Delaunay_view view(mesh);
      const Energy X = dirac_energy(view, CGP::no_potential(mesh));
      const Eigen::VectorXd values = eigenvalues(X);
      EXPECT_LT(values.maxCoeff(), bound) << height;
      EXPECT_GT(values.minCoeff(), -1e-13) << height;
      const Eigen::VectorXd now = eigenvalues(X, vertex_areas(view)).head(24);
      EXPECT_LT(now.head(4).cwiseAbs().maxCoeff(), 1e-11) << height;
      EXPECT_TRUE(now[4] > .01 || !is_closed) << height;
      if (low.size() == 0) low = now;
      EXPECT_LT((now - low).cwiseAbs().maxCoeff(), 2e-3 * low[23]) << height;
    }
    const Mesh_view thin = with_thin_faces(clean, 1e-6);
    EXPECT_GT(eigenvalues(dirac_energy(thin, CGP::no_potential(thin))).maxCoeff(), 1e5);
  }
}

TEST(Delaunay_operators, have_no_negative_cotan_weight_but_at_obtuse_angles_of_the_boundary)
{
  for (const Mesh_view& clean : {disk(4), annulus(.4, 1, 20, 4)}) {
    const Mesh_view mesh = spoilt(clean);
    const Delaunay_view view(mesh);
    EXPECT_GT(view.size_of_triangles(), mesh.size_of_faces());  // caps along the boundary
    const double cotangent_of_150_degrees = -std::sqrt(3);
    EXPECT_GT(cotan_weights(view).minCoeff(), cotangent_of_150_degrees / 2 - 1e-9);
    const Eigen::MatrixXd L = dense(cotan_laplacian(view, vertex_graph(view)));
    EXPECT_LT(L.rowwise().sum().cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_GT(symmetric_eigenvalues(L).minCoeff(), -1e-9);
  }
}

TEST(Delaunay_operators, have_the_low_spectrum_of_the_mesh_before_it_was_spoilt)
{
  // The space of functions has grown, so that the errors of discretisation differ a little.
  const Mesh_view clean = bumpy_sphere(2), mesh = with_thin_faces(clean, 1e-9, 1e-3);
  const Delaunay_view view(mesh);
  const Eigen::VectorXd expected =
      eigenvalues(dirac_energy(clean, CGP::no_potential(clean)), vertex_areas(clean)).head(48);
  const Eigen::VectorXd found =
      eigenvalues(dirac_energy(view, CGP::no_potential(mesh)), vertex_areas(view)).head(48);
  EXPECT_LT((found - expected).cwiseAbs().maxCoeff(), 1e-3 * expected[47]);
}

TEST(Delaunay_operators, are_positive_semidefinite_for_every_rho)
{
  for (const Mesh_view& mesh :
       {stretched_sphere(), spoilt(icosphere(1)), spoilt(stretched_sphere())})
    for (const auto on : both) {
      const Delaunay_view view(mesh);
      EXPECT_GT(view.number_of_flips(), 0);
      const Quaternion_matrix X = dense(dirac_energy(view, random_potential(mesh, on)));
      EXPECT_LT(hermitian_defect(X), 1e-15);
      const Eigen::VectorXd values = symmetric_eigenvalues(real_form(X));
      EXPECT_GT(values.minCoeff(), -1e-14 * values.maxCoeff());
    }
}

TEST(Delaunay_operators, have_the_constants_for_eigenvectors_of_constant_rho)
{
  // X 1 = rho^2 M 1 and D 1 - rho = -rho, where no length is mollified
  const Mesh_view mesh = stretched_sphere();
  const Delaunay_view view(mesh);
  EXPECT_GT(view.number_of_flips(), 10);
  const Eigen::VectorXd areas = vertex_areas(view);
  const auto one = Quaternion_vector<double>::Constant(mesh.size_of_vertices(), {1, 0, 0, 0});
  for (const double rho : {0., .7}) {
    const Curvature_potential potential =
        Curvature_potential::on_vertices(Eigen::VectorXd::Constant(mesh.size_of_vertices(), rho));
    const Quaternion_vector<double> image = dirac_energy(view, potential) * one;
    for (int v = 0; v < mesh.size_of_vertices(); ++v)
      EXPECT_LT(norm(image[v] - Quaternion<double>{rho * rho * areas[v], 0, 0, 0}), 1e-11);
    EXPECT_NEAR(dirac_quotient(view, potential, one), -rho, 1e-12);
  }
}

TEST(Delaunay_operators, have_the_intrinsic_Laplacian_for_real_part)
{
  const Mesh_view mesh = spoilt(stretched_sphere());
  const Delaunay_view view(mesh);
  const Eigen::MatrixXd L = dense(cotan_laplacian(view, vertex_graph(view)));
  const Eigen::MatrixXd X = real_part(dense(dirac_energy(view, CGP::no_potential(mesh))));
  EXPECT_LT((L - X).cwiseAbs().maxCoeff(), 1e-9 * L.maxCoeff());
  for (Eigen::Index i = 0; i < L.rows(); ++i)
    for (Eigen::Index j = 0; j < i; ++j) EXPECT_LT(L(i, j), 1e-9 * L(i, i));
  EXPECT_LT(L.rowwise().sum().cwiseAbs().maxCoeff(), 1e-12 * L.maxCoeff());
}

TEST(Delaunay_operators, add_what_a_triangle_with_one_corner_twice_has)
{
  // Both sides of a triangle, one of whose edges has been flipped by its obtuse angles.
  const Mesh_view mesh(points({{0, 0, 0}, {2, .5, 0}, {4, 0, 0}}), {{0, 1, 2}, {0, 2, 1}});
  const Delaunay_view view(mesh);
  EXPECT_EQ(view.number_of_flips(), 1);
  const Eigen::MatrixXd L = dense(cotan_laplacian(view, vertex_graph(view)));
  // Flat and isosceles, twice: the corner 1 is the same distance from both others, which have no
  // edge between them any more.
  EXPECT_NEAR(L(0, 2), 0, 1e-14);
  EXPECT_NEAR(L(0, 1), L(2, 1), 1e-14);
  EXPECT_NEAR(L(1, 1), -2 * L(0, 1), 1e-14);
  const Energy X = dirac_energy(view, CGP::no_potential(mesh));
  EXPECT_LT((real_part(dense(X)) - L).cwiseAbs().maxCoeff(), 1e-13);
  EXPECT_GT(eigenvalues(X).minCoeff(), -1e-14);
}

}  // namespace cgp_test::delaunay_operators_tests
