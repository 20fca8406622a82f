// Tests include/Conformal_geometry_processing/linear_algebra/direct/elimination_tree.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

#include <Conformal_geometry_processing/linear_algebra/direct/elimination_tree.h>

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

namespace cgp_test::supernodes_tests {

namespace CGP = Conformal_geometry_processing;

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

}  // namespace cgp_test::supernodes_tests
