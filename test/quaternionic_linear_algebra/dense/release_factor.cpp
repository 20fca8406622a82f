// Tests dense/block_operators.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/dense/block_operators.h>

#include <gtest/gtest.h>

namespace cgp_test::release_factor_tests {

namespace CGP = Conformal_geometry_processing;

TEST(Release_factor, is_passed_on_to_solvers_that_can)
{
  struct Solver {
    int releases = 0;
    void release() { ++releases; }
  } solver;
  CGP::release_factor(solver);
  EXPECT_EQ(solver.releases, 1);
}

TEST(Release_factor, leaves_other_solvers_alone)
{
  struct Solver {
    int factor = 7;
  } solver;
  CGP::release_factor(solver);
  EXPECT_EQ(solver.factor, 7);
}

}  // namespace cgp_test::release_factor_tests
