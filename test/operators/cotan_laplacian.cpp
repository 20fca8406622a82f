// Tests include/Conformal_geometry_processing/operators/cotan_laplacian.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>

#include <gtest/gtest.h>

#include <Eigen/Core>

#include "support/decompositions.h"
#include "support/dense.h"
#include "support/meshes.h"

namespace cgp_test::cotan_laplacian_tests {

namespace CGP = Conformal_geometry_processing;

TEST(Cotangent, of_the_angle_opposite_a_halfedge)
{
  const Mesh_view mesh = single_triangle();  // right angle at corner 0, legs 2 and 1
  EXPECT_EQ(CGP::cotangent(mesh, 0), 0);
  EXPECT_NEAR(CGP::cotangent(mesh, 1), 2, 1e-15);
  EXPECT_NEAR(CGP::cotangent(mesh, 2), .5, 1e-15);
}

TEST(Cotangent, is_negative_where_the_angle_is_obtuse)
{
  const Mesh_view mesh(points({{0, 0, 0}, {1, 0, 0}, {-1, 1, 0}}), {{0, 1, 2}});
  EXPECT_NEAR(CGP::cotangent(mesh, 0), -1, 1e-15);
}

TEST(Cotan_weights, of_the_square_are_half_a_cotangent_at_the_boundary_and_two_inside)
{
  // Edges 01, 02 (diagonal, opposite right angles), 03, 12, 23.
  Eigen::VectorXd wanted(5);
  wanted << .5, 0, .5, .5, .5;
  EXPECT_LT((CGP::cotan_weights(unit_square()) - wanted).norm(), 1e-15);
}

TEST(Cotan_weights, of_the_tetrahedron_are_one_over_the_root_of_three)
{
  for (double w : CGP::cotan_weights(tetrahedron())) EXPECT_NEAR(w, 1 / std::sqrt(3.), 1e-15);
}

TEST(Cotan_laplacian, is_the_sum_of_weighted_differences)
{
  const Mesh_view mesh = perturbed(disk(3), .1);
  const Eigen::VectorXd f = random_numbers(37, 1), w = CGP::cotan_weights(mesh);
  Eigen::VectorXd wanted = Eigen::VectorXd::Zero(37);
  for (int k = 0; k < mesh.size_of_edges(); ++k) {
    const auto [i, j] = mesh.ends(k);
    wanted[i] += w[k] * (f[i] - f[j]);
    wanted[j] += w[k] * (f[j] - f[i]);
  }
  EXPECT_LT((CGP::cotan_laplacian(mesh) * f - wanted).norm(), 1e-13);
}

TEST(Cotan_laplacian, is_assembled_again_for_other_weights)
{
  const Mesh_view mesh = perturbed(disk(3), .1);
  const auto wanted = CGP::cotan_laplacian(mesh);
  CGP::Hermitian_sparse_matrix<double> L(wanted.shared_pattern());
  CGP::assemble_cotan_laplacian(mesh, random_numbers(mesh.size_of_edges(), 2), L);
  CGP::assemble_cotan_laplacian(mesh, CGP::cotan_weights(mesh), L);
  for (int k = 0; k < wanted.pattern().size_of_entries(); ++k)
    EXPECT_EQ(L.value(k), wanted.value(k)) << k;
}

TEST(Cotan_laplacian, has_the_dirichlet_energy_of_linear_functions)
{
  // |grad (3x + 5y)|^2 = 34 times the area, exact for piecewise linear functions.
  const Mesh_view mesh = grid(3, 4, 2, 1);
  Eigen::VectorXd f(20);
  for (int v = 0; v < 20; ++v) f[v] = 3 * mesh.position(v).x() + 5 * mesh.position(v).y();
  EXPECT_NEAR(f.dot(CGP::cotan_laplacian(mesh) * f), 34 * 2, 1e-12);
}

TEST(Cotan_laplacian, is_positive_semidefinite_also_with_negative_weights)
{
  for (const Mesh_view& mesh : {perturbed(icosphere(1), .4), perturbed(disk(4), .2)}) {
    EXPECT_LT(CGP::cotan_weights(mesh).minCoeff(), -.1);  // or the test would not say much
    const Eigen::MatrixXd L = dense(CGP::cotan_laplacian(mesh));
    const Eigen::VectorXd eigenvalues = symmetric_eigenvalues(L);
    EXPECT_LT(std::abs(eigenvalues[0]), 1e-12);
    EXPECT_GT(eigenvalues[1], 1e-2);
    EXPECT_LT((L * Eigen::VectorXd::Ones(L.cols())).norm(), 1e-12);
  }
}

TEST(Cotan_laplacian, does_not_depend_on_the_unit_of_length)
{
  const Mesh_view mesh = perturbed(icosphere(1), .2);
  const Eigen::VectorXd w = CGP::cotan_weights(mesh);
  EXPECT_EQ(CGP::cotan_weights(scaled(mesh, 4)), w);
}

TEST(Cotan_laplacian, tends_to_minus_div_grad_of_spherical_harmonics)
{
  // On the unit sphere Delta (xy) = 6 xy, and the integral of (xy)^2 is 4 pi / 15.
  std::vector<double> h, error;
  for (int level : {2, 3, 4}) {
    const Mesh_view mesh = icosphere(level);
    Eigen::VectorXd f(mesh.size_of_vertices());
    for (int v = 0; v < f.size(); ++v) f[v] = mesh.position(v).x() * mesh.position(v).y();
    h.push_back(mean_edge_length(mesh));
    error.push_back(f.dot(CGP::cotan_laplacian(mesh) * f) - 6 * 4 * pi / 15);
  }
  EXPECT_NEAR(slope(h, error), 2, .1);
  EXPECT_LT(std::abs(error.back()), .02);
}

TEST(Cotan_laplacian, can_share_its_pattern_with_other_matrices)
{
  const Mesh_view mesh = icosphere(1);
  const auto pattern = CGP::vertex_graph(mesh);
  const auto L = CGP::cotan_laplacian(mesh, pattern);
  EXPECT_EQ(L.shared_pattern(), pattern);
  EXPECT_EQ(dense(L), dense(CGP::cotan_laplacian(mesh)));
}

}  // namespace cgp_test::cotan_laplacian_tests
