// Tests dense/Solver_status.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/dense/Solver_status.h>

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace cgp_test::solver_status_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Solver_status;

TEST(Solver_status, says_something_different_about_each_case)
{
  std::set<std::string> words;
  for (const Solver_status status :
       {Solver_status::success, Solver_status::not_positive_definite,
        Solver_status::numerical_issue, Solver_status::out_of_memory, Solver_status::wrong_state})
    words.insert(CGP::to_string(status));
  EXPECT_EQ(words.size(), 5u);
  EXPECT_EQ(words.count("unknown"), 0u);
  EXPECT_STREQ(CGP::to_string(static_cast<Solver_status>(-1)), "unknown");
}

}  // namespace cgp_test::solver_status_tests
