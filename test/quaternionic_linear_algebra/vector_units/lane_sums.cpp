// Tests include/Quaternionic_linear_algebra/vector_units/Simd_lanes.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

#include <Quaternionic_linear_algebra/vector_units/Simd_lanes.h>

#include <gtest/gtest.h>

namespace cgp_test::lane_sums_tests {

namespace CGP = Conformal_geometry_processing;

// Multiples of powers of two, so that the sums are exact and misplaced terms are detected.
template <class Unit, class Real, int count>
void expect_sums()
{
  using Simd = CGP::internal::Simd_lanes<Unit, Real>;
  constexpr int lanes = Simd::size;
  typename Simd::Register a[count];
  Real expected[count];
  for (int i = 0; i < count; ++i) {
    expected[i] = 0;
    for (int l = 0; l < lanes; ++l) {
      a[i][l] = static_cast<Real>((i + 1) * (1 << l));
      expected[i] += a[i][l];
    }
  }
  CGP::sum_lanes<Unit, Real>(a);
  for (int i = 0; i < count; ++i) EXPECT_EQ(a[i / lanes][i % lanes], expected[i]) << i;
}

template <class Unit>
void expect_sums_of_registers()
{
  expect_sums<Unit, double, 1>();
  expect_sums<Unit, double, 2>();
  expect_sums<Unit, double, 4>();
  expect_sums<Unit, double, 8>();
  expect_sums<Unit, float, 4>();
  expect_sums<Unit, float, 8>();
}

TEST(Lane_sums, follow_each_other_for_any_number_of_registers)
{
  expect_sums_of_registers<CGP::internal::Baseline_unit>();
  expect_sums_of_registers<CGP::internal::Target_unit>();
}

TEST(Lane_sums, of_small_and_large_numbers_are_added_in_pairs)
{
  using Simd = CGP::internal::Simd_lanes<CGP::internal::Target_unit, double>;
  Simd::Register a[1] = {};
  a[0][0] = 1e300;
  a[0][1] = -1e300;
  if (Simd::size > 2) a[0][Simd::size - 1] = 1;  // pairs before their sums
  CGP::sum_lanes<CGP::internal::Target_unit, double>(a);
  EXPECT_EQ(a[0][0], Simd::size > 2 ? 1 : 0);
}

}  // namespace cgp_test::lane_sums_tests
