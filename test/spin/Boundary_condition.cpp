// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Boundary_condition.h
#include <Conformal_geometry_processing/spin/Boundary_condition.h>

#include <gtest/gtest.h>

#include <Eigen/Core>

#include "support/mesh_tools.h"

namespace cgp_test::boundary_condition_tests {

using Conformal_geometry_processing::Boundary_condition;
using Kind = Boundary_condition::Kind;

Points constant(int count, double x = 1)
{
  return Eigen::Vector3d(x, 0, 0).replicate(1, count);
}

TEST(Boundary_condition, of_each_kind_has_what_it_needs)
{
  EXPECT_EQ(Boundary_condition().kind, Kind::free);
  EXPECT_EQ(Boundary_condition::free().kind, Kind::free);
  const auto tangents = Boundary_condition::tangents(constant(3));
  EXPECT_EQ(tangents.kind, Kind::directions);
  EXPECT_EQ(tangents.direction, Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(tangents.targets, constant(3));
  EXPECT_EQ(Boundary_condition::binormals().direction, Eigen::Vector3d(0, 0, 1));
  EXPECT_EQ(Boundary_condition::binormals().targets.cols(), 0);
  const auto positions = Boundary_condition::positions(constant(3), constant(3, 2));
  EXPECT_EQ(positions.kind, Kind::positions);
  EXPECT_EQ(positions.targets, constant(3));
  EXPECT_EQ(positions.normals, constant(3, 2));
}

TEST(Boundary_condition, is_self_adjoint_if_the_direction_is_orthogonal_to_the_tangent)
{
  EXPECT_TRUE(Boundary_condition::binormals().is_self_adjoint());
  EXPECT_TRUE(Boundary_condition::directions({0, 1, -2}).is_self_adjoint());
  EXPECT_FALSE(Boundary_condition::tangents().is_self_adjoint());
  EXPECT_FALSE(Boundary_condition::directions({.1, 0, 1}).is_self_adjoint());
  EXPECT_FALSE(Boundary_condition::free().is_self_adjoint());
}

}  // namespace cgp_test::boundary_condition_tests
