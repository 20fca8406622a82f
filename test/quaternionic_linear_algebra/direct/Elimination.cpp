// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/direct/Elimination.h>

#include <gtest/gtest.h>

#include "quaternionic_linear_algebra/symbolic_elimination.h"

#include <numeric>
#include <vector>

namespace cgp_test::elimination_tests {

using CGP::internal::Graph_rows;
using CGP::internal::Permuted_graph;
namespace CGP = Conformal_geometry_processing;

TEST(Permuted_graph, holds_every_edge_once_below_the_diagonal_with_its_place_in_the_pattern)
{
  for (const auto& [name, pattern, order] : ordered_graphs()) {
    SCOPED_TRACE(name);
    const Permuted_graph graph(*pattern, CGP::inverse_permutation(order));
    std::set<int> sources;
    for (int j = 0; j < graph.size(); ++j)
      for (const auto* e = graph.begin(j); e != graph.end(j); ++e) {
        const int a = order[at(e->row)], b = order[at(j)];
        EXPECT_GT(e->row, j);
        EXPECT_EQ(e->source, a > b ? pattern->find(a, b) : ~pattern->find(b, a));
        sources.insert(e->source < 0 ? ~e->source : e->source);
      }
    EXPECT_EQ(sources.size(), graph.entries.size());
    EXPECT_EQ(static_cast<int>(sources.size()), pattern->size_of_entries() - pattern->size());
  }
}

TEST(Permuted_graph, is_renumbered_as_if_it_were_made_of_the_other_ordering)
{
  const Pattern pattern = grid_pattern(4, 5);
  const CGP::internal::Ordering order = random_permutation(20, 3);
  const Permuted_graph graph(*pattern, CGP::inverse_permutation(order));
  const std::vector<int> post =
      CGP::postorder(CGP::elimination_tree(Graph_rows(graph)), std::vector<int>(20, 0));
  CGP::internal::Ordering second;
  for (int k : post) second.push_back(order[at(k)]);
  const Permuted_graph renumbered(graph, CGP::inverse_permutation(post));
  const Permuted_graph expected(*pattern, CGP::inverse_permutation(second));
  EXPECT_EQ(renumbered.offsets, expected.offsets);
  const auto sorted = [](const Permuted_graph& g) {
    std::set<std::array<int, 3>> entries;
    for (int j = 0; j < g.size(); ++j)
      for (const auto* e = g.begin(j); e != g.end(j); ++e) entries.insert({j, e->row, e->source});
    return entries;
  };
  EXPECT_EQ(sorted(renumbered), sorted(expected));
}

TEST(Graph_rows, list_the_columns_of_each_row_in_ascending_order)
{
  const Pattern pattern = random_pattern(30, 5);
  const Permuted_graph graph(*pattern, random_permutation(30, 6));
  const Graph_rows rows(graph);
  std::set<std::pair<int, int>> below;
  for (int j = 0; j < graph.size(); ++j)
    for (const auto* e = graph.begin(j); e != graph.end(j); ++e) below.insert({e->row, j});
  std::vector<std::pair<int, int>> listed;
  for (int i = 0; i < rows.size(); ++i)
    for (const int* j = rows.begin(i); j != rows.end(i); ++j) listed.push_back({i, *j});
  EXPECT_EQ(listed, (std::vector<std::pair<int, int>>(below.begin(), below.end())));
}

TEST(Elimination_tree, leads_to_the_first_row_below_each_diagonal)
{
  for (const auto& [name, pattern, order] : ordered_graphs()) {
    SCOPED_TRACE(name);
    const Permuted_graph graph(*pattern, CGP::inverse_permutation(order));
    EXPECT_EQ(CGP::elimination_tree(Graph_rows(graph)), parents(eliminated(*pattern, order)));
  }
}

TEST(Sorted_by, sorts_and_keeps_the_order_of_equal_keys)
{
  EXPECT_EQ(CGP::sorted_by({2, 0, 5, 2, 0, 1}), (std::vector<int>{1, 4, 5, 0, 3, 2}));
  EXPECT_EQ(CGP::sorted_by({}), std::vector<int>());
  EXPECT_EQ(CGP::sorted_by({1}), std::vector<int>{0});
}

TEST(Postorder, visits_children_first_and_the_heaviest_of_siblings_last)
{
  //      6          3
  //    / | \\        |
  //   0  5  2       4
  //      |
  //      1
  const std::vector<int> parent{6, 5, 6, -1, 3, 6, -1};
  EXPECT_EQ(CGP::postorder(parent, {4, 1, 2, 5, 5, 3, 6}), (std::vector<int>{4, 3, 2, 1, 5, 0, 6}));
}

TEST(Postorder, keeps_subtrees_together)
{
  for (const auto& [name, pattern, order] : ordered_graphs()) {
    SCOPED_TRACE(name);
    const std::vector<int> parent = parents(eliminated(*pattern, order));
    const std::vector<int> post = CGP::postorder(parent, std::vector<int>(parent.size(), 0));
    const std::vector<int> place = CGP::inverse_permutation(post);
    ASSERT_EQ(place.size(), parent.size());
    // The subtree of a node ends with the node and is as long as it has descendants.
    std::vector<int> descendants(parent.size(), 1), lowest(place);
    for (int k : post)
      if (const int p = parent[at(k)]; p >= 0) {
        EXPECT_LT(place[at(k)], place[at(p)]);
        descendants[at(p)] += descendants[at(k)];
        lowest[at(p)] = std::min(lowest[at(p)], lowest[at(k)]);
      }
    for (int k : post) EXPECT_EQ(place[at(k)] - lowest[at(k)] + 1, descendants[at(k)]);
  }
}

TEST(Column_counts, are_those_of_the_eliminated_graph)
{
  for (const auto& [name, pattern, order] : ordered_graphs()) {
    SCOPED_TRACE(name);
    const Factor_rows rows = eliminated(*pattern, order);
    const std::vector<int> parent = parents(rows);
    const Permuted_graph graph(*pattern, CGP::inverse_permutation(order));
    for (const auto& weight : {std::vector<int>(parent.size(), 0), counts(rows)})
      EXPECT_EQ(CGP::column_counts(graph, parent, CGP::postorder(parent, weight)), counts(rows));
  }
}

TEST(Elimination, is_that_of_its_order_in_which_subtrees_are_together)
{
  for (const auto& [name, pattern, order] : ordered_graphs()) {
    SCOPED_TRACE(name);
    const CGP::internal::Elimination E(*pattern, order);
    const Factor_rows rows = eliminated(*pattern, E.order());
    EXPECT_EQ(E.parent(), parents(rows));
    EXPECT_EQ(E.count(), counts(rows));
    std::vector<int> in_order(order.size());
    std::iota(in_order.begin(), in_order.end(), 0);
    EXPECT_EQ(CGP::postorder(E.parent(), E.count()), in_order);
    for (int j = 0; j < E.graph().size(); ++j)
      for (const auto* e = E.graph().begin(j); e != E.graph().end(j); ++e)
        EXPECT_EQ(rows[at(j)].count(e->row), 1u);
  }
}

}  // namespace cgp_test::elimination_tests
