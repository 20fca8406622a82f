// Tests linear_algebra/direct/minimum_degree_with_halo.h
// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/direct/minimum_degree_with_halo.h>

#include <gtest/gtest.h>

#include "linear_algebra/graphs.h"

using namespace cgp_test;

namespace {

CGP::internal::Graph_region region_of(int n, const Edges& edges)
{
  return CGP::graph_region(pattern_of(n, edges), Eigen::Matrix3Xd::Zero(3, n));
}

// Whether each vertex has the least degree when it is eliminated, by sets of neighbours.
void expect_minimum_degree(const CGP::internal::Graph_region& region, const std::vector<int>& order)
{
  const int n = region.size();
  std::vector<std::set<int>> neighbours(at(n));
  for (const auto& e : region.edges) {
    neighbours[at(e[0])].insert(e[1]);
    neighbours[at(e[1])].insert(e[0]);
  }
  for (const auto& e : region.halo) neighbours[at(e[0])].insert(n + e[1]);
  std::vector<char> is_done(at(n), 0);
  ASSERT_EQ(static_cast<int>(order.size()), n);
  for (int v : order) {
    ASSERT_FALSE(is_done[at(v)]);
    is_done[at(v)] = 1;
    for (int u = 0; u < n; ++u)
      EXPECT_TRUE(is_done[at(u)] || neighbours[at(u)].size() >= neighbours[at(v)].size());
    for (int u : neighbours[at(v)])
      if (u < n) {
        neighbours[at(u)].insert(neighbours[at(v)].begin(), neighbours[at(v)].end());
        neighbours[at(u)].erase(u);
        neighbours[at(u)].erase(v);
      }
  }
}

}  // namespace

TEST(Minimum_degree_with_halo, eliminates_a_vertex_of_least_degree_every_time)
{
  CGP::internal::Minimum_degree_with_halo minimum_degree;
  for (int n : {0, 1, 2, 63, 64, 65, 130, 200}) {
    const auto region = region_of(n, n < 2 ? Edges() : random_edges(n, 2 * n, 7));
    expect_minimum_degree(region, minimum_degree(region));
  }
}

TEST(Minimum_degree_with_halo, counts_the_halo_as_neighbours)
{
  CGP::internal::Minimum_degree_with_halo minimum_degree;
  for (int n : {3, 60, 64, 100}) {
    auto region = region_of(n, random_edges(n, 2 * n, 9));
    Random random(11);
    for (int k = 0; k < 2 * n; ++k)
      region.halo.push_back({random.below(n), 1000 + random.below(n)});
    expect_minimum_degree(region, minimum_degree(region));
  }
  auto path = region_of(3, path_edges(3));
  path.halo = {{0, 7}, {0, 8}, {2, 8}, {2, 9}};
  EXPECT_EQ(minimum_degree(path).front(), 1);
}

TEST(Minimum_degree_with_halo, names_the_vertices_of_the_whole_graph)
{
  auto region = region_of(3, star_edges(3));
  region.vertices = {40, 50, 60};
  CGP::internal::Minimum_degree_with_halo minimum_degree;
  std::vector<int> order = minimum_degree(region);
  std::sort(order.begin(), order.end());
  EXPECT_EQ(order, region.vertices);
}
