// Tests linear_algebra/direct/Graph_region.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/direct/Graph_region.h>

#include <gtest/gtest.h>

#include "linear_algebra/graphs.h"

namespace cgp_test::graph_region_tests {

using CGP::internal::Side;

TEST(Graph_region, has_every_edge_once_and_positions_in_the_unit_cube)
{
  Eigen::Matrix3Xd p(3, 3);
  p << 1e200, 3e200, 2e200, 0, 0, 5e199, 0, 0, 0;
  const auto region = CGP::graph_region(pattern_of(3, {{2, 0}, {1, 2}}), p);
  EXPECT_EQ(region.edges, (Edges{{0, 2}, {1, 2}}));
  EXPECT_EQ(region.vertices, (std::vector<int>{0, 1, 2}));
  EXPECT_TRUE(region.positions.col(0).isApprox(Eigen::Vector3f(-1, 1, 0)));
  EXPECT_TRUE(region.positions.col(1).isApprox(Eigen::Vector3f(-.25f, -.25f, .25f)));
  EXPECT_TRUE(region.positions.col(2).isZero());
}

TEST(Graph_region, of_one_point_lies_at_zero)
{
  const Eigen::Matrix3Xd p = Eigen::Matrix3Xd::Constant(3, 4, 7.);
  EXPECT_TRUE(CGP::graph_region(pattern_of(4, {}), p).positions.isZero(0));
}

TEST(Graph_region, splits_into_the_parts_beside_the_separator)
{
  // 0 - 1 - 2 - 3 - 4 and 0 - 2: the first separator is 2, the second 1.
  Edges edges = path_edges(5);
  edges.push_back({0, 2});
  const auto region = CGP::graph_region(pattern_of(5, edges), random_positions(5, 3));
  const Side l = Side::left, s = Side::separator, r = Side::right;
  const auto parts = CGP::split(region, {l, l, s, r, r});
  EXPECT_EQ(parts[0].vertices, (std::vector<int>{0, 1}));
  EXPECT_EQ(parts[0].edges, (Edges{{0, 1}}));
  EXPECT_EQ(parts[1].vertices, (std::vector<int>{3, 4}));
  EXPECT_EQ(parts[1].edges, (Edges{{0, 1}}));
  EXPECT_EQ(parts[1].positions, region.positions.bottomRows(2));

  const auto grandchildren = CGP::split(parts[0], {r, s});
  EXPECT_EQ(grandchildren[0].size(), 0);
  EXPECT_EQ(grandchildren[1].vertices, (std::vector<int>{0}));
}

}  // namespace cgp_test::graph_region_tests
