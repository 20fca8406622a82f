// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Quaternionic_linear_algebra/dense/Solver_status.h
#include <Quaternionic_linear_algebra/dense/Solver_status.h>

#include <gtest/gtest.h>

#include <stdexcept>

namespace cgp_test::guarded_tests {

using Conformal_geometry_processing::Solver_status;
using Conformal_geometry_processing::internal::guarded;

TEST(Guarded, returns_the_status_of_the_action)
{
  EXPECT_EQ(guarded([] { return Solver_status::success; }), Solver_status::success);
  EXPECT_EQ(guarded([] { return Solver_status::wrong_state; }), Solver_status::wrong_state);
}

TEST(Guarded, turns_bad_alloc_into_a_status)
{
  EXPECT_EQ(guarded([]() -> Solver_status { throw std::bad_alloc(); }),
            Solver_status::out_of_memory);
}

TEST(Guarded, lets_other_exceptions_pass)
{
  EXPECT_THROW(guarded([]() -> Solver_status { throw std::logic_error("a mistake"); }),
               std::logic_error);
}

}  // namespace cgp_test::guarded_tests
