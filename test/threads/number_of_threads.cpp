// Tests include/Conformal_geometry_processing/threads/number_of_threads.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

#include <Conformal_geometry_processing/threads/number_of_threads.h>

#include <gtest/gtest.h>

#include <thread>

namespace cgp_test::number_of_threads_tests {

namespace CGP = Conformal_geometry_processing;

TEST(Number_of_threads, is_one_unless_more_are_asked_for)
{
  EXPECT_EQ(CGP::number_of_threads(), 1);
  CGP::set_number_of_threads(3);
  EXPECT_EQ(CGP::number_of_threads(), 3);
  CGP::set_number_of_threads(1);
  EXPECT_EQ(CGP::number_of_threads(), 1);
}

TEST(Number_of_threads, is_that_of_the_machine_for_zero_or_less)
{
  for (const int all : {0, -1}) {
    CGP::set_number_of_threads(all);
    EXPECT_EQ(CGP::number_of_threads(),
              std::max(1, static_cast<int>(std::thread::hardware_concurrency())));
  }
  CGP::set_number_of_threads(1);
}

TEST(Number_of_threads, has_a_limit)
{
  CGP::set_number_of_threads(1000000);
  EXPECT_EQ(CGP::number_of_threads(), 1024);
  CGP::set_number_of_threads(1);
}

}  // namespace cgp_test::number_of_threads_tests
