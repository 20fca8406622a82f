// Tests include/Conformal_geometry_processing/flow/Time_step.h
// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Time_step.h>

#include <gtest/gtest.h>

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
