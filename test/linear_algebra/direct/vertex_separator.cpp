// Tests linear_algebra/direct/vertex_separator.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/direct/vertex_separator.h>

#include <gtest/gtest.h>

#include "linear_algebra/graphs.h"

namespace cgp_test::vertex_separator_tests {

using CGP::internal::Side;

CGP::internal::Graph_region grid_region(int a)
{
  return CGP::graph_region(pattern_of(a * a, grid_edges(a)), grid_positions(a));
}

int size_of(const std::vector<Side>& sides, Side side)
{
  return static_cast<int>(std::count(sides.begin(), sides.end(), side));
}

bool is_separated(const CGP::internal::Graph_region& region, const std::vector<Side>& sides)
{
  for (const auto& e : region.edges) {
    const Side a = sides[at(e[0])], b = sides[at(e[1])];
    if (a != b && a != Side::separator && b != Side::separator) return false;
  }
  return true;
}

TEST(Thin_separator, of_thick_columns_of_a_grid_is_one_column)
{
  const int a = 20;
  const CGP::internal::Graph_region region = grid_region(a);
  std::vector<Side> sides;
  for (int v = 0; v < a * a; ++v)
    sides.push_back(v % a < 8 ? Side::left : v % a < 13 ? Side::separator : Side::right);
  const std::vector<Side> before = sides;
  CGP::thin_separator(region, sides);
  EXPECT_TRUE(is_separated(region, sides));
  EXPECT_EQ(size_of(sides, Side::separator), a);
  for (std::size_t v = 0; v < sides.size(); ++v)
    EXPECT_TRUE(before[v] == Side::separator || sides[v] == before[v]);
}

TEST(Thin_separator, is_taken_from_the_greater_side)
{
  const int a = 10;
  const CGP::internal::Graph_region region = grid_region(a);
  std::vector<Side> sides;
  for (int v = 0; v < a * a; ++v) sides.push_back(v % a < 3 ? Side::left : Side::right);
  CGP::thin_separator(region, sides);
  EXPECT_TRUE(is_separated(region, sides));
  EXPECT_EQ(size_of(sides, Side::left), 3 * a);
  EXPECT_EQ(size_of(sides, Side::separator), a);
}

TEST(Thin_separator, separates_random_graphs_whatever_the_sides)
{
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const int n = 60;
    Random random(seed);
    const auto region =
        CGP::graph_region(pattern_of(n, random_edges(n, 90, seed)), random_positions(n, seed));
    std::vector<Side> sides;
    for (int v = 0; v < n; ++v) sides.push_back(static_cast<Side>(random.below(3)));
    const std::vector<Side> before = sides;
    CGP::thin_separator(region, sides);
    EXPECT_TRUE(is_separated(region, sides)) << "seed " << seed;
    for (std::size_t v = 0; v < sides.size(); ++v)
      EXPECT_TRUE(before[v] == Side::separator || sides[v] == before[v] ||
                  sides[v] == Side::separator);
  }
}

TEST(Thin_separator, is_empty_between_components)
{
  const auto region = CGP::graph_region(pattern_of(4, {{0, 1}, {2, 3}}), random_positions(4, 1));
  std::vector<Side> sides{Side::left, Side::left, Side::right, Side::right};
  CGP::thin_separator(region, sides);
  EXPECT_EQ(size_of(sides, Side::separator), 0);
}

}  // namespace cgp_test::vertex_separator_tests
