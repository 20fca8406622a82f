// Tests include/Conformal_geometry_processing/linear_algebra/multigrid/aggregate.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

#include <Conformal_geometry_processing/linear_algebra/multigrid/aggregate.h>

#include <gtest/gtest.h>

#include <queue>
#include <vector>

#include "linear_algebra/graphs.h"
#include "linear_algebra/hermitian_matrices.h"
#include "support/spheres.h"

namespace cgp_test::aggregate_tests {

using Ints = std::vector<int>;

CGP::internal::Connection_graph connections(const CGP::Sparse_pattern& pattern)
{
  const auto L = random_laplacian(std::make_shared<const CGP::Sparse_pattern>(pattern), 5);
  return CGP::strong_connections(L, 0);
}

/// the number of vertices that are reached from `start` within its aggregate
int reached(const CGP::internal::Connection_graph& g, const CGP::internal::Aggregation& a,
            int start)
{
  std::vector<bool> is_reached(at(g.size()));
  std::queue<int> queue;
  const auto reach = [&](int i) {
    if (is_reached[at(i)] || a.aggregate_of[at(i)] != a.aggregate_of[at(start)]) return;
    is_reached[at(i)] = true;
    queue.push(i);
  };
  reach(start);
  int count = 0;
  for (; !queue.empty(); queue.pop(), ++count)
    for (int k = g.begin(queue.front()); k < g.end(queue.front()); ++k) reach(g.neighbor(k));
  return count;
}

TEST(Aggregate, groups_a_path_by_threes)
{
  // The first vertex has one neighbor; the last but one is left over.
  const CGP::internal::Aggregation a = CGP::aggregate(connections(pattern_of(9, path_edges(9))));
  EXPECT_EQ(a.size, 3);
  EXPECT_EQ(a.aggregate_of, (Ints{0, 0, 1, 1, 1, 2, 2, 2, 2}));
}

TEST(Aggregate, joins_what_is_left_over_where_the_connection_is_strongest)
{
  // The path 0 - 1 - 2 - 4 - 3 in which 2 is left over between 1 and 4.
  CGP::internal::Connection_graph g{
      {0, 1, 3, 5, 6, 8}, {1, 0, 2, 1, 4, 4, 2, 3}, {9, 9, 2, 2, 1, 9, 1, 9}};
  EXPECT_EQ(CGP::aggregate(g).aggregate_of, (Ints{0, 0, 0, 1, 1}));
  std::swap(g.weights[2], g.weights[4]);
  std::swap(g.weights[3], g.weights[6]);
  EXPECT_EQ(CGP::aggregate(g).aggregate_of, (Ints{0, 0, 1, 1, 1}));
}

TEST(Aggregate, leaves_vertices_without_connections_alone)
{
  const CGP::internal::Aggregation a = CGP::aggregate(connections(pattern_of(6, {{1, 4}})));
  EXPECT_EQ(a.size, 1);
  EXPECT_EQ(a.aggregate_of, (Ints{-1, 0, -1, -1, 0, -1}));
}

TEST(Aggregate, gives_connected_groups_of_two_or_more_for_graphs_of_all_kinds)
{
  for (const Named_graph& graph : graphs_of_all_kinds()) {
    if (graph.size == 0) continue;
    const CGP::internal::Connection_graph g = connections(pattern_of(graph.size, graph.edges));
    const CGP::internal::Aggregation a = CGP::aggregate(g);
    Ints sizes(at(a.size), 0);
    for (int i = 0; i < g.size(); ++i) {
      const int of = a.aggregate_of[at(i)];
      ASSERT_EQ(of < 0, g.begin(i) == g.end(i)) << graph.name;
      ASSERT_LT(of, a.size) << graph.name;
      if (of >= 0) ++sizes[at(of)];
    }
    for (int i = 0; i < g.size(); ++i)
      if (const int of = a.aggregate_of[at(i)]; of >= 0) {
        ASSERT_GE(sizes[at(of)], 2) << graph.name;
        ASSERT_EQ(i % 7 == 0 ? reached(g, a, i) : sizes[at(of)], sizes[at(of)]) << graph.name;
      }
  }
}

TEST(Aggregate, makes_groups_of_about_nine_on_triangle_meshes)
{
  const Mesh_view mesh = geodesic_sphere(20);
  const CGP::internal::Aggregation a = CGP::aggregate(connections(pattern_of(mesh)));
  EXPECT_GT(mesh.size_of_vertices(), 7 * a.size);
  EXPECT_LT(mesh.size_of_vertices(), 12 * a.size);
}

}  // namespace cgp_test::aggregate_tests
