// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Quaternionic_linear_algebra/krylov/Visit_guard.h
#include <Quaternionic_linear_algebra/krylov/Visit_guard.h>

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace cgp_test::visit_guard_tests {

using Conformal_geometry_processing::Precondition_error;
using Conformal_geometry_processing::internal::Visit_guard;

bool allows(const Visit_guard& guard)
{
  try {
    guard.require_no_visit("f");
  } catch (const Precondition_error& error) {
    EXPECT_EQ(error.function(), "f");
    EXPECT_NE(error.message().find("called by its own visitor"), std::string::npos);
    return false;
  }
  return true;
}

TEST(Visit_guard, refuses_calls_during_a_visit_only)
{
  Visit_guard guard;
  EXPECT_TRUE(allows(guard));
  EXPECT_FALSE(guard.during([&] { return allows(guard); }));
  EXPECT_TRUE(allows(guard));
}

TEST(Visit_guard, passes_on_progress_and_answer)
{
  Visit_guard guard;
  const auto is_even = [&](int progress) {
    EXPECT_FALSE(allows(guard));
    return progress % 2 == 0;
  };
  EXPECT_TRUE(guard.guarded(is_even)(4));
  EXPECT_FALSE(guard.guarded(is_even)(5));
}

TEST(Visit_guard, ends_with_the_outermost_visit_or_an_exception)
{
  Visit_guard guard;
  guard.during([&] {
    guard.during([] {});
    EXPECT_FALSE(allows(guard));
  });
  EXPECT_THROW(guard.during([]() -> bool { throw std::runtime_error("visitor"); }),
               std::runtime_error);
  EXPECT_TRUE(allows(guard));
}

TEST(Visit_guard, of_a_copy_knows_no_visitor)
{
  Visit_guard guard, assigned;
  guard.during([&] {
    const Visit_guard copy(guard);
    assigned = guard;
    EXPECT_TRUE(allows(copy));
    EXPECT_TRUE(allows(assigned));
  });
}

}  // namespace cgp_test::visit_guard_tests
