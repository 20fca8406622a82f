// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests operators/calculus.h
#include <Conformal_geometry_processing/operators/calculus.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>

#include <gtest/gtest.h>

#include "support/dense.h"
#include "support/meshes.h"

namespace cgp_test::exterior_derivative_tests {

namespace CGP = Conformal_geometry_processing;

std::vector<Mesh_view> sample_meshes()
{
  return {perturbed(icosphere(1), .3), perturbed(disk(3), .1), torus(2, 1, 6, 5), double_torus()};
}

TEST(Exterior_derivative_0, is_the_difference_from_the_smaller_to_the_larger_vertex)
{
  const Eigen::MatrixXd d = CGP::exterior_derivative_0(single_triangle());
  Eigen::Matrix3d wanted;
  wanted << -1, 1, 0, -1, 0, 1, 0, -1, 1;  // edges 01, 02, 12
  EXPECT_EQ(d, wanted);
}

TEST(Exterior_derivative_1, is_the_sum_counter_clockwise_around_the_face)
{
  const Eigen::MatrixXd d = CGP::exterior_derivative_1(single_triangle());
  EXPECT_EQ(d, Eigen::RowVector3d(1, -1, 1));
  const Eigen::MatrixXd reversed =
      CGP::exterior_derivative_1(with_reversed_faces(single_triangle()));
  EXPECT_EQ(reversed, Eigen::RowVector3d(-1, 1, -1));
}

TEST(Exterior_derivatives, after_each_other_are_zero)
{
  for (const Mesh_view& mesh : sample_meshes()) {
    const Eigen::MatrixXd dd =
        Eigen::MatrixXd(CGP::exterior_derivative_1(mesh)) * CGP::exterior_derivative_0(mesh);
    EXPECT_EQ(dd, Eigen::MatrixXd::Zero(mesh.size_of_faces(), mesh.size_of_vertices()));
  }
}

TEST(Exterior_derivative_1, sees_each_inner_edge_from_both_sides)
{
  const Mesh_view mesh = torus(2, 1, 6, 5);
  const Eigen::RowVectorXd sum = Eigen::RowVectorXd::Ones(60) * CGP::exterior_derivative_1(mesh);
  EXPECT_EQ(sum, Eigen::RowVectorXd::Zero(90));
}

TEST(Exterior_derivative_0, with_cotan_weights_makes_the_cotan_laplacian)
{
  for (const Mesh_view& mesh : sample_meshes()) {
    const Eigen::MatrixXd d = CGP::exterior_derivative_0(mesh);
    const Eigen::MatrixXd L = d.transpose() * CGP::cotan_weights(mesh).asDiagonal() * d;
    EXPECT_LT((L - dense(CGP::cotan_laplacian(mesh))).cwiseAbs().maxCoeff(), 1e-13);
  }
}

}  // namespace cgp_test::exterior_derivative_tests
