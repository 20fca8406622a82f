// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests linear_algebra/vector_units/Lane_array.h, linear_algebra/vector_units/compiler_hints.h
#include <Conformal_geometry_processing/linear_algebra/vector_units/Lane_array.h>

#include <gtest/gtest.h>

namespace cgp_test::lane_array_tests {

struct Unit;
using Lanes = Conformal_geometry_processing::internal::Lane_array<Unit, double, 4>;

void expect_lanes(const Lanes& v, double a, double b, double c, double d)
{
  EXPECT_EQ(v[0], a);
  EXPECT_EQ(v[1], b);
  EXPECT_EQ(v[2], c);
  EXPECT_EQ(v[3], d);
}

TEST(Lane_array, computes_lane_by_lane)
{
  const Lanes a = {1, 2, 3, 4}, b = {5, -6, 7, 8};
  expect_lanes(a + b, 6, -4, 10, 12);
  expect_lanes(a - b, -4, 8, -4, -4);
  expect_lanes(a * b, 5, -12, 21, 32);
  expect_lanes(a * 2, 2, 4, 6, 8);
  expect_lanes(2 * a, 2, 4, 6, 8);
}

TEST(Lane_array, is_changed_in_place)
{
  Lanes v = {};
  v[2] = 3;
  v += {1, 1, 1, 1};
  expect_lanes(v, 1, 1, 4, 1);
  v -= {0, 1, 2, 3};
  expect_lanes(v, 1, 0, 2, -2);
  v *= {2, 2, 3, 3};
  expect_lanes(v, 2, 0, 6, -6);
  v *= 0.5;
  expect_lanes(v, 1, 0, 3, -3);
  v /= 2;
  expect_lanes(v, 0.5, 0, 1.5, -1.5);
}

}  // namespace cgp_test::lane_array_tests
