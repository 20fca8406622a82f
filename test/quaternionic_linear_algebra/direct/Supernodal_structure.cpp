// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/direct/Supernodal_structure.h>

#include <gtest/gtest.h>

#include "quaternionic_linear_algebra/symbolic_elimination.h"

#include <numeric>
#include <vector>

namespace cgp_test::supernodal_structure_tests {

using CGP::internal::Supernodal_structure;
namespace CGP = Conformal_geometry_processing;

TEST(Supernodal_structure, reorders_without_more_fill)
{
  for (const auto& [name, pattern, order] : ordered_graphs()) {
    SCOPED_TRACE(name);
    const Supernodal_structure S(*pattern, order);
    std::int64_t entries = 0;
    double operations = 0;
    for (int c : counts(eliminated(*pattern, order))) entries += c, operations += double(c) * c;
    EXPECT_EQ(S.factor_entries(), entries);
    EXPECT_EQ(S.operations(), operations);
    EXPECT_GE(S.stored_entries(), entries);
    std::int64_t again = 0;
    for (int c : counts(eliminated(*pattern, S.order()))) again += c;
    EXPECT_EQ(again, entries);
  }
}

TEST(Supernodal_structure, has_room_for_the_factor_and_only_rows_of_its_last_columns)
{
  for (const auto& [name, pattern, order] : ordered_graphs()) {
    SCOPED_TRACE(name);
    const Supernodal_structure S(*pattern, order);
    const Factor_rows rows = eliminated(*pattern, S.order());
    int next = 0;
    for (int s = 0; s < S.size(); ++s) {
      EXPECT_EQ(S.first(s), next);
      next += S.width(s);
      const std::set<int> below(S.rows(s), S.rows(s) + S.height(s));
      EXPECT_EQ(below, rows[at(next - 1)]);
      EXPECT_TRUE(std::is_sorted(S.rows(s), S.rows(s) + S.height(s)));
      for (int j = S.first(s); j < next; ++j)
        for (int i : rows[at(j)]) EXPECT_TRUE(i < next || below.count(i) == 1);
    }
    EXPECT_EQ(next, S.size_of_columns());
  }
}

TEST(Supernodal_structure, places_the_rows_of_children_in_the_front_of_the_parent)
{
  for (const auto& [name, pattern, order] : ordered_graphs()) {
    SCOPED_TRACE(name);
    const Supernodal_structure S(*pattern, order);
    int children = 0;
    for (int s = 0; s < S.size(); ++s) {
      EXPECT_EQ(S.depth(s), S.parent(s) < 0 ? 0 : S.depth(S.parent(s)) + 1);
      EXPECT_EQ(S.parent(s) < 0, S.height(s) == 0);
      for (const int* c = S.children_begin(s); c != S.children_end(s); ++c, ++children) {
        EXPECT_EQ(S.parent(*c), s);
        EXPECT_TRUE(c + 1 == S.children_end(s) || c[0] < c[1]);
        for (int i = 0; i < S.height(*c); ++i) {
          const int place = S.relative_rows(*c)[i];
          EXPECT_EQ(place < S.width(s) ? S.first(s) + place : S.rows(s)[place - S.width(s)],
                    S.rows(*c)[i]);
        }
      }
    }
    EXPECT_EQ(children, static_cast<int>(std::count_if(S.order().begin(), S.order().end(),
                                                       [&, s = 0](int) mutable {
                                                         return s < S.size() && S.parent(s++) >= 0;
                                                       })));
  }
}

TEST(Supernodal_structure, puts_every_entry_of_the_matrix_into_one_panel)
{
  for (const auto& [name, pattern, order] : ordered_graphs()) {
    SCOPED_TRACE(name);
    const Supernodal_structure S(*pattern, order);
    std::set<int> seen;
    for (int s = 0; s < S.size(); ++s)
      for (const auto* e = S.entries_begin(s); e != S.entries_end(s); ++e) {
        const int row = e->row < S.width(s) ? S.first(s) + e->row : S.rows(s)[e->row - S.width(s)];
        const int a = S.order()[at(row)], b = S.order()[at(S.first(s) + e->column)];
        EXPECT_EQ(e->source, a >= b ? pattern->find(a, b) : ~pattern->find(b, a));
        EXPECT_GE(e->row, e->column);
        EXPECT_TRUE(seen.insert(e->source < 0 ? ~e->source : e->source).second);
      }
    EXPECT_EQ(static_cast<int>(seen.size()), pattern->size_of_entries());
  }
}

TEST(Supernodal_structure, stores_a_dense_matrix_in_a_chain_of_supernodes_without_zeros)
{
  const Supernodal_structure S(*full_pattern(300), random_permutation(300, 1));
  EXPECT_EQ(S.size(), 5);
  EXPECT_EQ(S.stored_entries(), 300 * 301 / 2);
  for (int s = 0; s < S.size(); ++s) EXPECT_EQ(S.parent(s), s + 1 < S.size() ? s + 1 : -1);
}

TEST(Supernodal_structure, keeps_vertices_at_the_end_in_their_order_and_eliminates_all_others)
{
  for (const auto& [name, pattern, order] : ordered_graphs())
    for (const int share : {1, 2, 4}) {
      SCOPED_TRACE(name);
      const int n = pattern->size(), kept = (n + share - 1) / share, eliminated_ones = n - kept;
      const Supernodal_structure S(*pattern, order, kept);
      EXPECT_EQ(S.size_of_kept(), kept);
      EXPECT_EQ(S.size_of_columns(), n);
      EXPECT_TRUE(std::equal(order.end() - kept, order.end(), S.order().end() - kept));
      const Factor_rows rows = eliminated(*pattern, S.order());
      double operations = 0;
      for (int j = 0; j < eliminated_ones; ++j)
        operations += double(rows[at(j)].size() + 1) * double(rows[at(j)].size() + 1);
      EXPECT_EQ(S.operations(), operations);
      int next = 0;
      for (int s = 0; s < S.size(); ++s) {
        EXPECT_EQ(S.first(s), next);
        next += S.width(s);
        const std::set<int> below(S.rows(s), S.rows(s) + S.height(s));
        EXPECT_EQ(below, rows[at(next - 1)]);
        EXPECT_EQ(S.parent(s) < 0, below.empty() || *below.begin() >= eliminated_ones);
      }
      EXPECT_EQ(next, eliminated_ones);
    }
}

TEST(Supernodal_structure, has_no_entries_between_kept_vertices)
{
  for (const auto& [name, pattern, order] : ordered_graphs()) {
    SCOPED_TRACE(name);
    const int n = pattern->size(), kept = n / 3;
    const std::vector<int> place = CGP::inverse_permutation(order);
    int expected = 0, entries = 0;
    for (int j = 0; j < n; ++j)
      for (int k = pattern->offsets[at(j)]; k < pattern->offsets[at(j + 1)]; ++k)
        expected += std::min(place[at(j)], place[at(pattern->indices[at(k)])]) < n - kept;
    const Supernodal_structure S(*pattern, order, kept);
    for (int s = 0; s < S.size(); ++s)
      entries += static_cast<int>(S.entries_end(s) - S.entries_begin(s));
    EXPECT_EQ(entries, expected);
  }
}

/// a chain of n columns, each the parent of the one before
std::vector<int> chain(int n)
{
  std::vector<int> parent(static_cast<std::size_t>(n));
  std::iota(parent.begin(), parent.end(), 1);
  parent.back() = -1;
  return parent;
}

std::vector<int> dense_counts(int n)
{
  std::vector<int> count(static_cast<std::size_t>(n));
  for (int j = 0; j < n; ++j) count[static_cast<std::size_t>(j)] = n - j;
  return count;
}

TEST(Fundamental_supernodes, are_columns_with_the_same_rows_below)
{
  // Columns 0 and 1 are leaves under 2; 2, 3, 4 are dense.
  EXPECT_EQ(CGP::internal::fundamental_supernodes({2, 2, 3, 4, -1}, {3, 2, 3, 2, 1}),
            (std::vector<int>{0, 1, 2, 5}));
  EXPECT_EQ(CGP::internal::fundamental_supernodes(chain(4), dense_counts(4)),
            (std::vector<int>{0, 4}));
}

TEST(Fundamental_supernodes, end_where_another_child_joins)
{
  // Column 1 has the rows of 2 and 2 itself, but 0 is a child of 2 too.
  EXPECT_EQ(CGP::internal::fundamental_supernodes({2, 2, -1}, {2, 2, 1}),
            (std::vector<int>{0, 1, 2, 3}));
}

TEST(Relaxed_supernodes, merge_a_narrow_child_into_its_parent)
{
  EXPECT_EQ(CGP::relaxed_supernodes({2, 2, -1}, {2, 2, 1}), (std::vector<int>{0, 1, 3}));
}

TEST(Relaxed_supernodes, do_not_merge_separate_trees)
{
  EXPECT_EQ(CGP::relaxed_supernodes({-1, -1, -1}, {1, 1, 1}), (std::vector<int>{0, 1, 2, 3}));
}

TEST(Relaxed_supernodes, do_not_merge_what_would_store_mostly_zeros)
{
  // A long dense chain of 40 under which a path of one more row per column would be padded.
  std::vector<int> parent = chain(100), count(100, 2);
  for (int j = 60; j < 100; ++j) count[static_cast<std::size_t>(j)] = 100 - j;
  const std::vector<int> first = CGP::relaxed_supernodes(parent, count);
  double stored = 0, needed = std::accumulate(count.begin(), count.end(), 0.0);
  for (std::size_t s = 0; s + 1 < first.size(); ++s) {
    const int width = first[s + 1] - first[s];
    const int below = count[static_cast<std::size_t>(first[s + 1] - 1)] - 1;
    stored += width * (width + 1) / 2.0 + double(width) * below;
    EXPECT_LE(first[s] < 60 ? width : 1, 48);
  }
  EXPECT_LE(stored, 2 * needed);
  EXPECT_GE(stored, needed);
}

TEST(Relaxed_supernodes, are_cut_into_even_pieces)
{
  for (const int n : {1, 63, 64, 65, 200, 1000}) {
    const std::vector<int> first = CGP::relaxed_supernodes(chain(n), dense_counts(n));
    EXPECT_EQ(first.front(), 0);
    EXPECT_EQ(first.back(), n);
    EXPECT_EQ(first.size(), static_cast<std::size_t>((n + 63) / 64 + 1));
    for (std::size_t s = 0; s + 1 < first.size(); ++s) {
      EXPECT_GE(first[s + 1] - first[s], n / static_cast<int>(first.size() - 1));
      EXPECT_LE(first[s + 1] - first[s], CGP::max_supernode_width);
    }
  }
}

}  // namespace cgp_test::supernodal_structure_tests
