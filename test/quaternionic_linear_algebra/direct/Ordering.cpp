// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/direct/Ordering.h>
#include <Quaternionic_linear_algebra/direct/Supernodal_cholesky.h>

#include <gtest/gtest.h>

#include "quaternionic_linear_algebra/graphs.h"
#include "quaternionic_linear_algebra/hermitian_matrices.h"
#include "quaternionic_linear_algebra/symbolic_elimination.h"
#include "support/spheres.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace cgp_test::ordering_tests {

namespace CGP = Conformal_geometry_processing;

TEST(Inverse_permutation, gives_the_new_number_of_every_old_one)
{
  EXPECT_EQ(CGP::inverse_permutation({2, 0, 3, 1}), (std::vector<int>{1, 3, 0, 2}));
  EXPECT_TRUE(CGP::inverse_permutation({}).empty());
}

TEST(Inverse_permutation, refuses_what_is_no_permutation)
{
  EXPECT_TRUE(CGP::inverse_permutation({0, 1, 1}).empty());
  EXPECT_TRUE(CGP::inverse_permutation({0, 3, 1}).empty());
  EXPECT_TRUE(CGP::inverse_permutation({0, -1, 1}).empty());
}

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

TEST(Breadth_first_ordering, permutes_the_vertices_of_any_graph)
{
  for (const Named_graph& graph : graphs_of_all_kinds()) {
    const CGP::internal::Ordering order =
        CGP::breadth_first_ordering(pattern_of(graph.size, graph.edges));
    EXPECT_EQ(static_cast<int>(order.size()), graph.size) << graph.name;
    EXPECT_EQ(CGP::inverse_permutation(order).size(), order.size()) << graph.name;
  }
}

TEST(Breadth_first_ordering, walks_along_a_path_from_its_end)
{
  EXPECT_EQ(CGP::breadth_first_ordering(pattern_of(5, {{2, 0}, {0, 4}, {4, 1}, {1, 3}})),
            (CGP::internal::Ordering{3, 1, 4, 0, 2}));
}

TEST(Breadth_first_ordering, visits_one_component_after_the_other)
{
  EXPECT_EQ(CGP::breadth_first_ordering(pattern_of(5, {{0, 3}, {1, 4}})),
            (CGP::internal::Ordering{3, 0, 4, 1, 2}));
}

TEST(Breadth_first_ordering, keeps_neighbours_near_whatever_the_numbers_of_the_mesh)
{
  const Mesh_view sphere = geodesic_sphere(20);
  const Mesh_view mesh = renumbered(sphere, random_permutation(sphere.size_of_vertices(), 1));
  const std::vector<int> place =
      CGP::inverse_permutation(CGP::breadth_first_ordering(pattern_of(mesh)));
  int farthest = 0;
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    farthest =
        std::max(farthest, std::abs(place[at(mesh.ends(k)[0])] - place[at(mesh.ends(k)[1])]));
  // Two zigzag rings around the sphere, of at most about 5 * 20 vertices.
  EXPECT_LT(farthest, 2 * 2 * 100);
}

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

}  // namespace cgp_test::ordering_tests
