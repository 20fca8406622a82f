// Tests include/Conformal_geometry_processing/operators/Curvature_potential.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Conformal_geometry_processing/operators/calculus.h>

#include <gtest/gtest.h>

#include "support/dense.h"
#include "support/meshes.h"

namespace cgp_test::curvature_potential_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Curvature_potential;

TEST(Curvature_potential, on_faces_is_the_same_at_the_three_corners)
{
  const auto rho = Curvature_potential::on_faces(Eigen::Vector2d(5, 7));
  EXPECT_EQ(rho.at_corners(unit_square().sheet(0)), Eigen::Vector3d(5, 5, 5));
  EXPECT_EQ(rho.at_corners(unit_square().sheet(1)), Eigen::Vector3d(7, 7, 7));
}

TEST(Curvature_potential, on_vertices_follows_the_corners)
{
  const auto rho = Curvature_potential::on_vertices(Eigen::Vector4d(2, 3, 5, 7));
  EXPECT_EQ(rho.at_corners(unit_square().sheet(0)), Eigen::Vector3d(2, 3, 5));
  EXPECT_EQ(rho.at_corners(unit_square().sheet(1)), Eigen::Vector3d(2, 5, 7));
}

TEST(Potential_matrix, on_faces_averages_and_then_multiplies)
{
  const Mesh_view mesh = disk(3);
  const Eigen::VectorXd rho = random_numbers(mesh.size_of_faces(), 1);
  const Quaternion_vector<double> lambda = random_quaternions(mesh.size_of_vertices(), 2);
  const Quaternion_vector<double> R_lambda =
      CGP::potential_matrix(mesh, Curvature_potential::on_faces(rho)) * lambda;
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const auto& v = mesh.corners(f);
    const Quaternion<double> wanted = rho[f] / 3 * (lambda[v[0]] + lambda[v[1]] + lambda[v[2]]);
    EXPECT_LT(norm(R_lambda[f] - wanted), 1e-15);
  }
}

TEST(Potential_matrix, on_vertices_multiplies_and_then_averages)
{
  const Mesh_view mesh = disk(3);
  const Eigen::VectorXd rho = random_numbers(mesh.size_of_vertices(), 1);
  const Quaternion_vector<double> lambda = random_quaternions(mesh.size_of_vertices(), 2);
  const Quaternion_vector<double> R_lambda =
      CGP::potential_matrix(mesh, Curvature_potential::on_vertices(rho)) * lambda;
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    Quaternion<double> wanted;
    for (int v : mesh.corners(f)) wanted += rho[v] / 3 * lambda[v];
    EXPECT_LT(norm(R_lambda[f] - wanted), 1e-15);
  }
}

TEST(Mean_of_a_potential, is_the_constant_if_it_is_constant)
{
  const Mesh_view mesh = bumpy_sphere(1);
  const auto on_faces = Curvature_potential::on_faces(Eigen::VectorXd::Constant(80, 3));
  const auto on_vertices = Curvature_potential::on_vertices(Eigen::VectorXd::Constant(42, 3));
  EXPECT_NEAR(CGP::mean(mesh, on_faces), 3, 1e-14);
  EXPECT_NEAR(CGP::mean(mesh, on_vertices), 3, 1e-14);
}

TEST(Mean_of_a_potential, weighs_by_area)
{
  // A face of area 1 and one of area 3.
  const Mesh_view mesh(points({{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, -3, 0}}),
                       {{0, 1, 2}, {0, 3, 1}});
  EXPECT_NEAR(CGP::mean(mesh, Curvature_potential::on_faces(Eigen::Vector2d(8, 4))), 5, 1e-14);
  // Vertices 0 and 1 have a third of both: (4 a + 4 b + c + 3 d) / 12.
  EXPECT_NEAR(CGP::mean(mesh, Curvature_potential::on_vertices(Eigen::Vector4d(1, 2, 6, 10))), 4,
              1e-14);
}

}  // namespace cgp_test::curvature_potential_tests
