// Tests algebra/Hermitian_sparse_matrix.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <thread>
#include <vector>

namespace cgp_test::sparse_pattern_tests {

namespace CGP = Conformal_geometry_processing;

// The path 0 - 1 - 2, and the edge 0 - 3.
const CGP::Sparse_pattern pattern{{0, 3, 5, 6, 7}, {0, 1, 3, 1, 2, 2, 3}};

TEST(Sparse_pattern, counts_rows_and_entries)
{
  EXPECT_EQ(pattern.size(), 4);
  EXPECT_EQ(pattern.size_of_entries(), 7);
  EXPECT_EQ(CGP::Sparse_pattern{}.size(), 0);
}

TEST(Sparse_pattern, finds_what_it_stores_and_nothing_else)
{
  EXPECT_EQ(pattern.find(0, 0), 0);
  EXPECT_EQ(pattern.find(3, 0), 2);
  EXPECT_EQ(pattern.find(2, 1), 4);
  EXPECT_EQ(pattern.find(3, 3), 6);
  EXPECT_EQ(pattern.find(2, 0), -1);
  EXPECT_EQ(pattern.find(3, 1), -1);
  EXPECT_EQ(pattern.find(3, 2), -1);
}

TEST(Sparse_pattern, compares_by_content)
{
  CGP::Sparse_pattern other = pattern;
  EXPECT_TRUE(other == pattern);
  other.indices[2] = 2;
  EXPECT_FALSE(other == pattern);
}

TEST(Sparse_pattern, is_made_of_rows_in_any_order_each_as_often_as_it_comes)
{
  EXPECT_TRUE(*CGP::sparse_pattern({{3, 1, 3, 0}, {2}, {}, {}}) == pattern);
  EXPECT_EQ(CGP::sparse_pattern({})->size(), 0);
}

TEST(Sparse_pattern, lists_its_rows_below_the_diagonal)
{
  const auto& rows = pattern.rows();
  EXPECT_EQ(rows.offsets, (std::vector<int>{0, 0, 1, 2, 3}));
  ASSERT_EQ(rows.entries.size(), 3u);
  const auto is = [&](std::size_t i, int column, int position) {
    return rows.entries[i].column == column && rows.entries[i].position == position;
  };
  EXPECT_TRUE(is(0, 0, 1) && is(1, 1, 4) && is(2, 0, 2));
  EXPECT_EQ(&pattern.rows(), &rows);
}

TEST(Sparse_pattern, finds_its_rows_anew_when_it_was_copied)
{
  CGP::Sparse_pattern other = pattern;
  EXPECT_NE(&other.rows(), &pattern.rows());
  other = {{0, 1, 2}, {0, 1}};
  EXPECT_TRUE(other.rows().entries.empty());
}

TEST(Sparse_pattern, finds_its_rows_once_for_several_threads)
{
  const CGP::Sparse_pattern other = pattern;
  std::vector<const CGP::internal::Lower_rows*> seen(8);
  std::vector<std::thread> threads;
  for (auto& rows : seen) threads.emplace_back([&] { rows = &other.rows(); });
  for (std::thread& t : threads) t.join();
  EXPECT_EQ(seen, std::vector<const CGP::internal::Lower_rows*>(8, &other.rows()));
}

}  // namespace cgp_test::sparse_pattern_tests
