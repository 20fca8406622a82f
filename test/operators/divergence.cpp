// Tests include/Conformal_geometry_processing/operators/cotan_laplacian.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace cgp_test::divergence_tests {

namespace CGP = Conformal_geometry_processing;

TEST(Differential, is_the_value_at_the_larger_end_minus_that_at_the_smaller)
{
  Eigen::MatrixXd u(3, 2), wanted(3, 2);
  u << 1, -2, 10, 5, 100, 7;
  wanted << 9, 7, 99, 9, 90, 2;  // along 01, 02, 12
  EXPECT_EQ(CGP::differential(single_triangle(), u), wanted);
}

TEST(Codifferential, sums_what_flows_into_a_vertex_minus_what_flows_out)
{
  // Edges 01, 02, 12 with weights 1, 2, 3.
  const Eigen::Vector3d flow(10, 20, 30);
  EXPECT_EQ(CGP::codifferential(single_triangle(), Eigen::Vector3d(1, 2, 3), flow),
            Eigen::Vector3d(-10 - 40, 10 - 90, 40 + 90));
}

TEST(Codifferential, of_a_gradient_is_the_laplacian)
{
  for (const Mesh_view& mesh : {perturbed(icosphere(1), .3), perturbed(disk(3), .1)}) {
    const Eigen::VectorXd w = CGP::cotan_weights(mesh);
    const Eigen::VectorXd f = random_numbers(mesh.size_of_vertices(), 5);
    const Eigen::VectorXd wanted = CGP::cotan_laplacian(mesh) * f;
    EXPECT_LT((CGP::codifferential(mesh, w, CGP::differential(mesh, f)) - wanted).norm(), 1e-12);
  }
}

TEST(Codifferential, treats_every_column_alone)
{
  const Mesh_view mesh = perturbed(icosphere(1), .3);
  const Eigen::VectorXd w = CGP::cotan_weights(mesh);
  const Eigen::MatrixX3d omega = CGP::differential(mesh, mesh.positions().transpose());
  const Eigen::MatrixX3d all = CGP::codifferential(mesh, w, omega);
  for (int c = 0; c < 3; ++c) EXPECT_EQ(all.col(c), CGP::codifferential(mesh, w, omega.col(c)));
}

TEST(Codifferential, sums_to_zero)
{
  const Mesh_view mesh = perturbed(disk(3), .1);
  const Eigen::VectorXd omega = random_numbers(mesh.size_of_edges(), 2);
  EXPECT_NEAR(CGP::codifferential(mesh, CGP::cotan_weights(mesh), omega).sum(), 0, 1e-12);
}

TEST(Codifferential, is_adjoint_to_the_difference)
{
  const Mesh_view mesh = perturbed(disk(3), .1);
  const Eigen::VectorXd w = CGP::cotan_weights(mesh);
  const Eigen::VectorXd f = random_numbers(mesh.size_of_vertices(), 5);
  const Eigen::VectorXd omega = random_numbers(mesh.size_of_edges(), 2);
  EXPECT_NEAR(f.dot(CGP::codifferential(mesh, w, omega)),
              CGP::differential(mesh, f).col(0).dot(w.cwiseProduct(omega)), 1e-12);
}

}  // namespace cgp_test::divergence_tests
