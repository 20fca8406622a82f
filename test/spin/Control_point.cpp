// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Control_point.h
#include <Conformal_geometry_processing/spin/Control_point.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "support/meshes.h"

namespace cgp_test::control_point_tests {

namespace CGP = Conformal_geometry_processing::internal;
using CGP::control_point;
using CGP::Control_point;

const Eigen::Vector3d origin = Eigen::Vector3d::Zero();

Eigen::Affine3d some_motion()
{
  return Eigen::Translation3d(1, 2, -3) *
         Eigen::AngleAxisd(.7, Eigen::Vector3d(1, 2, 2).normalized());
}

std::vector<int> upper_vertices(const Mesh_view& mesh, double z)
{
  std::vector<int> all;
  for (int v = 0; v < mesh.size_of_vertices(); ++v)
    if (mesh.position(v).z() > z) all.push_back(v);
  return all;
}

std::string complaint(const std::vector<Control_point>& points, int vertices)
{
  try {
    CGP::require_control_points(points, vertices, "test");
  } catch (const Conformal_geometry_processing::Precondition_error& error) {
    return error.what();
  }
  return "";
}

TEST(Control_points, of_a_region_move_with_it)
{
  const Mesh_view mesh = perturbed(icosphere(2), .02);
  const Eigen::Affine3d motion = some_motion();
  const auto points = CGP::region_control_points(mesh, upper_vertices(mesh, .3), motion);
  ASSERT_EQ(points.size(), 4u);
  const Points moved = (motion * mesh.positions()).eval();
  EXPECT_LT((CGP::positions_of(points, moved) - CGP::targets_of(points)).norm(), 1e-13);
  EXPECT_NO_THROW(CGP::require_control_points(points, mesh.size_of_vertices(), "test"));
}

// The centre and three points at distances that are the radii of gyration, along orthogonal axes.
TEST(Control_points, of_a_region_are_on_its_axes)
{
  const Mesh_view mesh = perturbed(icosphere(2), .02);
  const auto points =
      CGP::region_control_points(mesh, upper_vertices(mesh, -.2), Eigen::Affine3d::Identity());
  ASSERT_EQ(points.size(), 4u);
  const Points arms = CGP::targets_of(points).rightCols(3).colwise() - points[0].target;
  const Eigen::Matrix3d gram = arms.transpose() * arms;
  EXPECT_LT((gram - Eigen::Matrix3d(gram.diagonal().asDiagonal())).norm(), 1e-12);
  double second_moment = 0;
  for (std::size_t i = 0; i < points[0].vertices.size(); ++i)
    second_moment += points[0].weights[Eigen::Index(i)] *
                     (mesh.position(points[0].vertices[i]) - points[0].target).squaredNorm();
  EXPECT_NEAR(gram.trace(), second_moment, 1e-12);
}

TEST(Control_points, of_a_flat_region_and_of_a_vertex_are_fewer)
{
  const Mesh_view flat = grid(4, 4);
  std::vector<int> all(static_cast<std::size_t>(flat.size_of_vertices()));
  for (std::size_t v = 0; v < all.size(); ++v) all[v] = static_cast<int>(v);
  EXPECT_EQ(CGP::region_control_points(flat, all, some_motion()).size(), 3u);
  const auto one = CGP::region_control_points(flat, {3}, some_motion());
  ASSERT_EQ(one.size(), 1u);
  EXPECT_LT((one[0].target - some_motion() * flat.position(3)).norm(), 1e-14);
}

TEST(Control_points, that_make_no_sense_are_named)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(complaint({}, 9).find("no targets"), std::string::npos);
  EXPECT_NE(complaint({control_point(0, origin), control_point(9, origin)}, 9)
                .find("target 1 is for vertex 9, but the mesh has 9"),
            std::string::npos);
  EXPECT_NE(complaint({control_point(-1, origin)}, 9).find("target 0"), std::string::npos);
  EXPECT_NE(complaint({control_point(2, {0, nan, 0})}, 9).find("not finite"), std::string::npos);
  EXPECT_NE(
      complaint({control_point(4, origin), control_point(5, origin), control_point(4, origin)}, 9)
          .find("target 2 is for vertex 4, as is target 0"),
      std::string::npos);
  Control_point heavy = control_point(1, origin);
  heavy.weights *= 2;
  EXPECT_NE(complaint({heavy}, 9).find("sum is not 1"), std::string::npos);
  EXPECT_NE(complaint({{{}, Eigen::VectorXd(), origin}}, 9).find("no vertices"), std::string::npos);
}

}  // namespace cgp_test::control_point_tests
