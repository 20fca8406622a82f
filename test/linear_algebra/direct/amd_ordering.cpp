// Tests include/Conformal_geometry_processing/linear_algebra/direct/Ordering.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

#include <Conformal_geometry_processing/linear_algebra/direct/Ordering.h>

#include <gtest/gtest.h>

#include <numeric>

#include "linear_algebra/symbolic_elimination.h"

namespace cgp_test::amd_ordering_tests {

int factor_entries(const CGP::Sparse_pattern& pattern, const CGP::internal::Ordering& order)
{
  const std::vector<int> count = counts(eliminated(pattern, order));
  return std::accumulate(count.begin(), count.end(), 0);
}

TEST(Amd_ordering, is_a_permutation_of_every_graph)
{
  for (const auto& [name, pattern, order] : ordered_graphs()) {
    SCOPED_TRACE(name);
    EXPECT_EQ(CGP::inverse_permutation(CGP::amd_ordering(*pattern)).size(), order.size());
  }
}

TEST(Amd_ordering, has_no_fill_on_stars_and_little_on_trees)
{
  const Pattern star = pattern_of_edges(6, {{3, 0}, {3, 1}, {3, 2}, {3, 4}, {3, 5}});
  EXPECT_EQ(factor_entries(*star, CGP::amd_ordering(*star)), 11);
  std::vector<std::pair<int, int>> edges;
  for (int i = 1; i < 63; ++i) edges.push_back({i, (i - 1) / 2});
  const Pattern tree = pattern_of_edges(63, edges);
  EXPECT_LE(factor_entries(*tree, CGP::amd_ordering(*tree)), (63 + 62) * 5 / 4);
}

TEST(Amd_ordering, fills_less_than_half_of_what_the_rows_of_a_grid_do)
{
  const Pattern grid = grid_pattern(24, 24);
  CGP::internal::Ordering rows(24 * 24);
  std::iota(rows.begin(), rows.end(), 0);
  EXPECT_LT(factor_entries(*grid, CGP::amd_ordering(*grid)), factor_entries(*grid, rows) / 2);
}

}  // namespace cgp_test::amd_ordering_tests
