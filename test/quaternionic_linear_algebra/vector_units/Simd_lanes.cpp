// Tests vector_units/kernel_arithmetic.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/vector_units/Simd_lanes.h>

#include <gtest/gtest.h>

#include <cstdint>

namespace cgp_test::simd_lanes_tests {

namespace CGP = Conformal_geometry_processing;

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

// The unit of every machine, and the widest for which this file is compiled.
template <class Lanes>
class Simd_lanes : public testing::Test {};
using All_lanes = testing::Types<CGP::internal::Simd_lanes<CGP::internal::Baseline_unit, float>,
                                 CGP::internal::Simd_lanes<CGP::internal::Baseline_unit, double>,
                                 CGP::internal::Simd_lanes<CGP::internal::Target_unit, float>,
                                 CGP::internal::Simd_lanes<CGP::internal::Target_unit, double>>;
TYPED_TEST_SUITE(Simd_lanes, All_lanes);

template <class Unit, class Real>
Real number_of(CGP::internal::Simd_lanes<Unit, Real>);
template <class Lanes>
using Number = decltype(number_of(Lanes()));

TYPED_TEST(Simd_lanes, fill_a_register)
{
  EXPECT_EQ(sizeof(typename TypeParam::Register), sizeof(Number<TypeParam>) * TypeParam::size);
  EXPECT_GE(TypeParam::size, 2);
  EXPECT_EQ(64 % sizeof(typename TypeParam::Register), 0u);  // arrays are aligned to 64 bytes
}

TYPED_TEST(Simd_lanes, are_computed_one_by_one)
{
  using Real = Number<TypeParam>;
  alignas(64) Real a[TypeParam::size], b[TypeParam::size];
  for (int i = 0; i < TypeParam::size; ++i) a[i] = Real(i + 1), b[i] = Real(3 * i - 5);
  TypeParam::store(a, TypeParam::load(b) - TypeParam::load(a) * b[1]);
  for (int i = 0; i < TypeParam::size; ++i)
    EXPECT_EQ(a[i], Real(3 * i - 5) - Real(i + 1) * Real(-2));
}

TYPED_TEST(Simd_lanes, are_converted_from_whole_numbers)
{
  using Real = Number<TypeParam>;
  alignas(64) std::int16_t whole[TypeParam::size];
  alignas(64) Real a[TypeParam::size];
  for (int i = 0; i < TypeParam::size; ++i)
    whole[i] = static_cast<std::int16_t>(i % 2 ? 32767 - i : i - 32768);
  TypeParam::store(a, TypeParam::load(whole));
  for (int i = 0; i < TypeParam::size; ++i) EXPECT_EQ(a[i], Real(whole[i]));
}

TYPED_TEST(Simd_lanes, can_be_set_alone)
{
  using Real = Number<TypeParam>;
  alignas(64) Real a[TypeParam::size];
  for (int lane = 0; lane < TypeParam::size; ++lane) {
    typename TypeParam::Register v = {};
    TypeParam::set_lane(v, lane, Real(7));
    TypeParam::store(a, v);
    for (int i = 0; i < TypeParam::size; ++i) EXPECT_EQ(a[i], i == lane ? Real(7) : Real(0));
  }
}

TYPED_TEST(Simd_lanes, are_the_rows_of_a_row_block)
{
  const CGP::internal::Panel_layout layout = TypeParam::layout(4);
  EXPECT_EQ(layout.lanes(), TypeParam::size);
  EXPECT_EQ(layout.planes, 4);
}

}  // namespace cgp_test::simd_lanes_tests
