// Tests include/Conformal_geometry_processing/linear_algebra/direct/Simd_lanes.h
// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later

#include <Conformal_geometry_processing/linear_algebra/direct/Simd_lanes.h>

#include <gtest/gtest.h>

namespace cgp_test {
namespace {

namespace CGP = Conformal_geometry_processing;

template <class Real>
class Simd_lanes : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(Simd_lanes, Reals);

TYPED_TEST(Simd_lanes, fill_a_register_of_the_target)
{
  using Lanes = CGP::Simd_lanes<TypeParam>;
  EXPECT_EQ(sizeof(typename Lanes::Register), static_cast<std::size_t>(CGP::internal::simd_bytes));
  EXPECT_GE(Lanes::size, 2);
  EXPECT_EQ(64 % sizeof(typename Lanes::Register), 0u);  // arrays are aligned to 64 bytes
}

TYPED_TEST(Simd_lanes, are_computed_one_by_one)
{
  using Lanes = CGP::Simd_lanes<TypeParam>;
  alignas(64) TypeParam a[Lanes::size], b[Lanes::size];
  for (int i = 0; i < Lanes::size; ++i) a[i] = TypeParam(i + 1), b[i] = TypeParam(3 * i - 5);
  Lanes::store(a, Lanes::load(b) - Lanes::load(a) * b[1]);
  for (int i = 0; i < Lanes::size; ++i)
    EXPECT_EQ(a[i], TypeParam(3 * i - 5) - TypeParam(i + 1) * TypeParam(-2));
}

}  // namespace
}  // namespace cgp_test
