// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Step_control.h>

#include <gtest/gtest.h>

namespace cgp_test::step_control_tests {

using Conformal_geometry_processing::internal::Pause;
using Conformal_geometry_processing::internal::Time_step;

TEST(Time_step, starts_with_the_first)
{
  EXPECT_EQ(Time_step(0.7, 0.1, 0.7).value(), 0.7);
  EXPECT_EQ(Time_step(0.7, 0.1, 0.2).value(), 0.2);
}

TEST(Time_step, halves_down_to_the_smallest_and_stays_there)
{
  Time_step step(1, 0.25, 1);
  EXPECT_TRUE(step.halve());
  EXPECT_EQ(step.value(), 0.5);
  EXPECT_TRUE(step.halve());
  EXPECT_EQ(step.value(), 0.25);
  EXPECT_FALSE(step.halve());
  EXPECT_EQ(step.value(), 0.25);
}

TEST(Time_step, grows_by_half_up_to_the_largest)
{
  Time_step step(1, 0.1, 1);
  step.grow();
  EXPECT_EQ(step.value(), 1);
  step.halve();
  step.grow();
  EXPECT_EQ(step.value(), 0.75);
  step.grow();
  EXPECT_EQ(step.value(), 1);
}

// Growth by half undoes halving in 1.7 successes; without waiting, one trial fails for as many.
TEST(Time_step, fails_once_in_three_successes_at_most_where_a_step_is_the_largest)
{
  for (const double largest : {0.2, 0.25, 0.3, 0.35}) {
    Time_step step(1, 1e-3, 0.25);
    int failures = 0, successes = 0;
    while (successes < 300) {
      if (step.value() > largest) {
        EXPECT_TRUE(step.halve());
        ++failures;
      } else {
        step.grow();
        ++successes;
      }
    }
    EXPECT_LT(3 * failures, successes + 30) << largest;
  }
}

TEST(Time_step, waits_twice_as_long_each_time_that_growth_fails_at_once)
{
  Time_step step(1, 1e-6, 0.1);
  for (const int waiting : {1, 2, 4, 8}) {
    step.grow();
    step.halve();
    const double halved = step.value();
    for (int k = 0; k < waiting; ++k) {
      step.grow();
      EXPECT_EQ(step.value(), halved);
    }
  }
}

TEST(Time_step, grows_at_once_after_growth_has_lasted)
{
  Time_step step(1, 0.01, 0.1);
  const auto fail_after_growth = [&] {
    step.grow();
    step.halve();
    int waiting = 0;
    for (const double before = step.value(); step.value() == before; ++waiting) step.grow();
    return waiting - 1;
  };
  EXPECT_EQ(fail_after_growth(), 1);
  for (int k = 0; k < 3; ++k) step.grow();
  EXPECT_EQ(fail_after_growth(), 1);
}

TEST(Time_step, may_grow_by_another_factor)
{
  Time_step step(8, 0.1, 1, 2);
  for (const double value : {2., 4., 8., 8.}) {
    step.grow();
    EXPECT_EQ(step.value(), value);
  }
}

TEST(Pause, lasts_ever_longer_until_what_is_left_out_is_worthwhile)
{
  Pause pause;
  const auto steps_without = [&](bool is_worthwhile) {
    pause.learn(is_worthwhile);
    int steps = 0;
    while (pause.holds()) ++steps;
    return steps;
  };
  EXPECT_FALSE(pause.holds());
  for (const int steps : {1, 2, 4, 8}) EXPECT_EQ(steps_without(false), steps);
  EXPECT_EQ(steps_without(true), 0);
  for (const int steps : {1, 2}) EXPECT_EQ(steps_without(false), steps);
}

TEST(Pause, ends_when_told)
{
  Pause pause;
  pause.learn(false);
  pause.end();
  EXPECT_FALSE(pause.holds());
}

}  // namespace cgp_test::step_control_tests
