// Tests linear_algebra/direct/sweep_cut.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/direct/sweep_cut.h>

#include <gtest/gtest.h>

#include "linear_algebra/graphs.h"

namespace cgp_test::sweep_cut_tests {

using CGP::internal::Side;

int size_of(const std::vector<Side>& sides, Side side)
{
  return static_cast<int>(std::count(sides.begin(), sides.end(), side));
}

std::vector<Side> sides_of(int n, const Edges& edges, const Eigen::Matrix3Xd& positions)
{
  return CGP::internal::Sweep_cut()(CGP::graph_region(pattern_of(n, edges), positions));
}

TEST(Sweep_cut, leaves_a_quarter_on_either_side)
{
  for (int n : {2, 3, 4, 10, 100, 1000}) {
    const auto sides = sides_of(n, random_edges(n, 2 * n, 1), random_positions(n, 2));
    EXPECT_GE(size_of(sides, Side::left), n / 4) << n;
    EXPECT_GE(size_of(sides, Side::right), n / 4) << n;
  }
}

// A row of 40 x 10 vertices that only one edge joins to a row of 24 x 10 vertices.
TEST(Sweep_cut, finds_the_neck_away_from_the_middle)
{
  Eigen::Matrix3Xd p(3, 640);
  Edges edges;
  for (int k = 0; k < 640; ++k) {
    p.col(k) << k / 10, k % 10, 0;
    if (k % 10 < 9) edges.push_back({k, k + 1});
    if (k < 630 && (k / 10 != 39 || k % 10 == 5)) edges.push_back({k, k + 10});
  }
  const auto sides = sides_of(640, edges, p);
  const Side first = sides.front(), last = sides.back();
  EXPECT_NE(first, last);
  for (int k = 0; k < 640; ++k) {
    EXPECT_TRUE(sides[at(k)] == Side::separator || sides[at(k)] == (k < 400 ? first : last));
  }
}

// All cuts across a strip are equal except for the sizes of the parts.
TEST(Sweep_cut, of_a_strip_is_in_the_middle)
{
  Eigen::Matrix3Xd p(3, 800);
  Edges edges;
  for (int k = 0; k < 800; ++k) {
    p.col(k) << k / 4, k % 4, 0;
    if (k % 4 < 3) edges.push_back({k, k + 1});
    if (k < 796) edges.push_back({k, k + 4});
  }
  const auto sides = sides_of(800, edges, p);
  EXPECT_NEAR(size_of(sides, Side::left), size_of(sides, Side::right), 16);
}

TEST(Sweep_cut, halves_vertices_that_coincide)
{
  const int n = 101;
  const auto sides = sides_of(n, path_edges(n), Eigen::Matrix3Xd::Zero(3, n));
  EXPECT_EQ(size_of(sides, Side::left), 50);
  EXPECT_EQ(size_of(sides, Side::right), 51);
}

TEST(Sweep_cut, halves_where_most_vertices_coincide)
{
  const int n = 100;
  Eigen::Matrix3Xd p = Eigen::Matrix3Xd::Zero(3, n);
  p.col(0) << 1, 2, 3;
  p.col(99) << -1, 0, 5;
  const auto sides = sides_of(n, path_edges(n), p);
  EXPECT_EQ(size_of(sides, Side::left), 50);
  EXPECT_EQ(size_of(sides, Side::right), 50);
}

}  // namespace cgp_test::sweep_cut_tests
