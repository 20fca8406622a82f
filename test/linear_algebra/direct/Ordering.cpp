// Tests linear_algebra/direct/Ordering.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/direct/Ordering.h>

#include <gtest/gtest.h>

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

}  // namespace cgp_test::ordering_tests
