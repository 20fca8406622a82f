// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/linear_algebra/direct/expanded_graph.h
#include <Conformal_geometry_processing/linear_algebra/direct/Ordering.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Supernodal_cholesky.h>
#include <Conformal_geometry_processing/linear_algebra/direct/expanded_graph.h>

#include <gtest/gtest.h>

#include "linear_algebra/hermitian_matrices.h"

namespace cgp_test::expanded_graph_tests {

TEST(Expanded_pattern, replaces_entries_by_blocks)
{
  const Pattern edge_and_point = pattern_of_edges(3, {{0, 2}});
  const CGP::Sparse_pattern expanded = CGP::expanded_pattern(*edge_and_point, 2);
  EXPECT_EQ(expanded.offsets, (std::vector<int>{0, 4, 7, 9, 10, 12, 13}));
  EXPECT_EQ(expanded.indices, (std::vector<int>{0, 1, 4, 5, 1, 4, 5, 2, 3, 3, 4, 5, 5}));
}

TEST(Expanded_pattern, of_width_one_is_the_same)
{
  const Pattern pattern = random_pattern(20, 1);
  EXPECT_EQ(CGP::expanded_pattern(*pattern, 1), *pattern);
}

TEST(Expanded_pattern, of_nothing_is_empty)
{
  EXPECT_EQ(CGP::expanded_pattern({}, 4).size(), 0);
}

TEST(Expanded_ordering, keeps_the_rows_of_a_block_together)
{
  EXPECT_EQ(CGP::expanded_ordering({2, 0, 1}, 2), (CGP::internal::Ordering{4, 5, 0, 1, 2, 3}));
}

TEST(Expanded_graph, serves_matrices_that_are_only_real_linear)
{
  // Blocks of independent numbers: no multiplication by a quaternion.
  const Pattern blocks = random_pattern(25, 2);
  const auto pattern =
      std::make_shared<const CGP::Sparse_pattern>(CGP::expanded_pattern(*blocks, 4));
  const auto A = random_definite<double>(pattern, 3);
  CGP::Supernodal_cholesky<double> solver;
  const CGP::internal::Ordering order = CGP::amd_ordering(*blocks);
  ASSERT_EQ(solver.analyze(*pattern, CGP::expanded_ordering(order, 4)),
            CGP::Solver_status::success);
  ASSERT_EQ(solver.factorize(A, {}), CGP::Solver_status::success);
  const auto b = random_block<double>(100, 2, 4);
  CGP::Block<double> x;
  ASSERT_EQ(solver.solve(b, x), CGP::Solver_status::success);
  EXPECT_LE((real_form(A) * x - b).norm(), 1e-12 * b.norm());
}

}  // namespace cgp_test::expanded_graph_tests
