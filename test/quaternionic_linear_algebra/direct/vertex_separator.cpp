// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/direct/vertex_separator.h>

#include <gtest/gtest.h>

#include "quaternionic_linear_algebra/graphs.h"

namespace cgp_test::vertex_separator_tests {

using CGP::internal::Side;
using CGP::internal::Terminal_graph;

Terminal_graph random_graph(int n, int edges, int sources, int sinks, std::uint64_t seed)
{
  Random random(seed);
  Terminal_graph graph{random_edges(n, edges, seed), std::vector<char>(at(n), 0),
                       std::vector<char>(at(n), 0)};
  for (int k = 0; k < sources; ++k) graph.is_source[at(random.below(n))] = 1;
  for (int k = 0; k < sinks; ++k) graph.is_sink[at(random.below(n))] = 1;
  return graph;
}

// Whether a path avoids the vertices of the mask on its way from a source to a sink.
bool is_connected_without(const Terminal_graph& graph, unsigned removed)
{
  unsigned reached = 0;
  for (int v = 0; v < graph.size(); ++v)
    if (graph.is_source[at(v)]) reached |= 1u << v;
  reached &= ~removed;
  for (unsigned before = 0; before != reached;) {
    before = reached;
    for (const auto& e : graph.edges)
      for (int k : {0, 1})
        if (reached >> e[at(k)] & 1u) reached |= (1u << e[at(1 - k)]) & ~removed;
  }
  for (int v = 0; v < graph.size(); ++v)
    if (graph.is_sink[at(v)] && (reached >> v & 1u)) return true;
  return false;
}

int count_ones(unsigned mask)
{
  int count = 0;
  for (; mask != 0; mask &= mask - 1) ++count;
  return count;
}

int size_of_smallest_cut(const Terminal_graph& graph)
{
  int least = graph.size();
  for (unsigned mask = 0; mask < 1u << graph.size(); ++mask)
    if (count_ones(mask) < least && !is_connected_without(graph, mask)) least = count_ones(mask);
  return least;
}

int size_of_separator(const std::vector<Side>& sides)
{
  return static_cast<int>(std::count(sides.begin(), sides.end(), Side::separator));
}

void expect_separated(const Terminal_graph& graph, const std::vector<Side>& sides)
{
  for (const auto& e : graph.edges) {
    const Side a = sides[at(e[0])], b = sides[at(e[1])];
    EXPECT_TRUE(a == b || a == Side::separator || b == Side::separator);
  }
  for (int v = 0; v < graph.size(); ++v) {
    EXPECT_FALSE(graph.is_source[at(v)] && sides[at(v)] == Side::right);
    EXPECT_FALSE(graph.is_sink[at(v)] && sides[at(v)] == Side::left);
  }
}

TEST(Minimum_vertex_cut, of_an_hourglass_is_its_waist)
{
  const Terminal_graph graph{{{0, 3}, {1, 3}, {2, 3}, {3, 4}, {3, 5}, {3, 6}},
                             {1, 1, 1, 0, 0, 0, 0},
                             {0, 0, 0, 0, 1, 1, 1}};
  const Side l = Side::left, s = Side::separator, r = Side::right;
  EXPECT_EQ(CGP::minimum_vertex_cut(graph), (std::vector<Side>{l, l, l, s, r, r, r}));
}

TEST(Minimum_vertex_cut, is_the_one_nearest_to_the_sources)
{
  const Terminal_graph path{path_edges(5), {1, 0, 0, 0, 0}, {0, 0, 0, 0, 1}};
  const Side s = Side::separator, r = Side::right;
  EXPECT_EQ(CGP::minimum_vertex_cut(path), (std::vector<Side>{s, r, r, r, r}));
}

TEST(Minimum_vertex_cut, holds_what_is_source_and_sink)
{
  const Terminal_graph graph{{{0, 1}}, {1, 1}, {0, 1}};
  EXPECT_EQ(CGP::minimum_vertex_cut(graph)[1], Side::separator);
}

// The shortest path 0 ... 8 must give up 2 and 6, for three paths 0 1 27 ... 34, 21 ... 26 3 4 5
// 17 ... 20 and 9 ... 16 7 8.
TEST(Minimum_vertex_cut, finds_paths_that_lead_back_along_others)
{
  const int n = 35;
  Terminal_graph graph{path_edges(9), std::vector<char>(n, 0), std::vector<char>(n, 0)};
  const auto add_chain = [&](int first, int last) {
    for (int v = first; v < last; ++v) graph.edges.push_back({v, v + 1});
  };
  add_chain(9, 16);
  add_chain(17, 20);
  add_chain(21, 26);
  add_chain(27, 34);
  for (const auto& e : Edges{{16, 7}, {5, 17}, {26, 3}, {1, 27}}) graph.edges.push_back(e);
  graph.is_source[0] = graph.is_source[9] = graph.is_source[21] = 1;
  graph.is_sink[8] = graph.is_sink[20] = graph.is_sink[34] = 1;
  const std::vector<Side> sides = CGP::minimum_vertex_cut(graph);
  expect_separated(graph, sides);
  EXPECT_EQ(size_of_separator(sides), 3);
}

TEST(Minimum_vertex_cut, is_empty_where_nothing_is_to_be_separated)
{
  EXPECT_TRUE(CGP::minimum_vertex_cut({}).empty());
  EXPECT_EQ(size_of_separator(CGP::minimum_vertex_cut({{{0, 1}}, {1, 0, 0}, {0, 0, 1}})), 0);
}

TEST(Minimum_vertex_cut, separates_with_as_few_vertices_as_any_set)
{
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    const int n = 4 + static_cast<int>(seed % 8);
    const Terminal_graph graph = random_graph(n, 1 + static_cast<int>(seed % 17), 3, 3, seed);
    const std::vector<Side> sides = CGP::minimum_vertex_cut(graph);
    expect_separated(graph, sides);
    EXPECT_EQ(size_of_separator(sides), size_of_smallest_cut(graph)) << "seed " << seed;
  }
}

TEST(Minimum_vertex_cut, of_a_bipartite_graph_is_a_smallest_vertex_cover)
{
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Terminal_graph graph{{}, std::vector<char>(10, 0), std::vector<char>(10, 0)};
    for (int v = 0; v < 10; ++v) (v < 5 ? graph.is_source : graph.is_sink)[at(v)] = 1;
    Random random(seed);
    for (int k = 0; k < 9; ++k) graph.edges.push_back({random.below(5), 5 + random.below(5)});
    const std::vector<Side> sides = CGP::minimum_vertex_cut(graph);
    int least = 10;
    for (unsigned mask = 0; mask < 1u << 10; ++mask) {
      bool is_cover = true;
      for (const auto& e : graph.edges)
        is_cover = is_cover && ((mask >> e[0] & 1u) || (mask >> e[1] & 1u));
      if (is_cover) least = std::min(least, count_ones(mask));
    }
    expect_separated(graph, sides);
    EXPECT_EQ(size_of_separator(sides), least) << "seed " << seed;
  }
}

// Menger: a grid has as many disjoint paths from side to side as it has rows, whatever is dug out.
TEST(Minimum_vertex_cut, of_a_large_grid_is_its_narrowest_column)
{
  const int a = 40, gap = 23, width = 7;
  Terminal_graph graph{{}, std::vector<char>(a * a, 0), std::vector<char>(a * a, 0)};
  const auto is_removed = [&](int v) { return v % a == gap && v / a >= width; };
  for (const auto& e : grid_edges(a))
    if (!is_removed(e[0]) && !is_removed(e[1])) graph.edges.push_back(e);
  for (int j = 0; j < a; ++j) {
    graph.is_source[at(j * a)] = 1;
    graph.is_sink[at(j * a + a - 1)] = 1;
  }
  const std::vector<Side> sides = CGP::minimum_vertex_cut(graph);
  expect_separated(graph, sides);
  EXPECT_EQ(size_of_separator(sides), width);
}

// One path has 100000 vertices: recursion would exhaust the stack.
TEST(Minimum_vertex_cut, follows_long_paths)
{
  const int n = 100000;
  Terminal_graph graph{path_edges(n), std::vector<char>(n, 0), std::vector<char>(n, 0)};
  graph.is_source.front() = graph.is_sink.back() = 1;
  EXPECT_EQ(size_of_separator(CGP::minimum_vertex_cut(graph)), 1);
}

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
