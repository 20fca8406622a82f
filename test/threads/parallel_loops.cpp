// Tests include/Conformal_geometry_processing/threads/parallel_loops.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/threads/parallel_loops.h>

#include <gtest/gtest.h>

#include <mutex>
#include <stdexcept>
#include <string>

#include "threads/threads.h"

namespace cgp_test::parallel_loops_tests {

namespace CGP = Conformal_geometry_processing;
using namespace CGP::internal;
using cgp_test::Threads;

TEST(For_each_range, visits_every_element_once)
{
  for (const int threads : {1, 2, 5}) {
    const Threads setting(threads);
    for (const int count : {0, 1, 2, 7, 1000})
      for (const int least : {1, 3, 400}) {
        std::vector<std::atomic<int>> visits(static_cast<std::size_t>(count));
        for (auto& v : visits) v = 0;
        for_each_index(count, least, [&](int i) { ++visits[static_cast<std::size_t>(i)]; });
        for (const auto& v : visits) EXPECT_EQ(v, 1);
      }
  }
}

TEST(For_each_range, makes_ranges_that_are_worth_it)
{
  const Threads setting(4);
  const Thread_team team;
  for (const int per_thread : {1, 3}) {
    std::mutex mutex;
    std::vector<std::ptrdiff_t> sizes;
    for_each_range(
        1000, 30,
        [&](std::ptrdiff_t first, std::ptrdiff_t last) {
          const std::lock_guard<std::mutex> lock(mutex);
          sizes.push_back(last - first);
        },
        per_thread);
    EXPECT_EQ(sizes.size(), static_cast<std::size_t>(4 * per_thread));
    for (const auto size : sizes) EXPECT_GE(size, 30);
  }
  int ranges = 0;
  for_each_range(59, 30, [&](std::ptrdiff_t, std::ptrdiff_t) { ++ranges; });
  EXPECT_EQ(ranges, 1);
}

TEST(For_each_range, hands_an_exception_to_the_caller)
{
  for (const int threads : {1, 2}) {
    const Threads setting(threads);
    EXPECT_THROW(for_each_index(100, 1,
                                [](int i) {
                                  if (i == 57) throw std::domain_error("57");
                                }),
                 std::domain_error);
  }
}

double sum_of_inverses(int count, std::ptrdiff_t least)
{
  const auto add = [](std::ptrdiff_t first, std::ptrdiff_t last, double& sum) {
    for (std::ptrdiff_t i = first; i < last; ++i) sum += 1. / static_cast<double>(i + 1);
  };
  return sum_of_ranges(count, 100, 0., add, least);
}

TEST(Sum_of_ranges, has_the_same_bits_for_any_number_of_threads)
{
  for (const int count : {0, 1, 100, 101, 10000}) {
    const double one = sum_of_inverses(count, 1);
    double plain = 0;
    for (int i = 0; i < count; ++i) plain += 1. / (i + 1);
    EXPECT_NEAR(one, plain, 1e-12);
    for (const int threads : {2, 3, 7})
      for (const int least : {1, 10}) {
        const Threads setting(threads);
        EXPECT_EQ(sum_of_inverses(count, least), one);
      }
  }
}

TEST(Sum_of_ranges, adds_in_the_order_of_the_elements)
{
  struct Word {
    std::string letters;
    Word& operator+=(const Word& other)
    {
      letters += other.letters;
      return *this;
    }
  };
  const Threads setting(3);
  const auto add = [](std::ptrdiff_t first, std::ptrdiff_t last, Word& word) {
    for (std::ptrdiff_t i = first; i < last; ++i) word.letters += static_cast<char>('a' + i);
  };
  EXPECT_EQ(sum_of_ranges(26, 4, Word(), add).letters, "abcdefghijklmnopqrstuvwxyz");
}

}  // namespace cgp_test::parallel_loops_tests
