// Tests include/Quaternionic_linear_algebra/direct/Aligned_array.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

#include <Quaternionic_linear_algebra/direct/Aligned_array.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <new>

namespace cgp_test::aligned_array_tests {

namespace CGP = Conformal_geometry_processing;

bool is_aligned(const void* p)
{
  return reinterpret_cast<std::uintptr_t>(p) % 64 == 0;
}

TEST(Aligned_array, begins_at_a_cache_line_whatever_its_size)
{
  for (const std::int64_t size : {1, 3, 1000, 100000, 3000000}) {
    CGP::internal::Aligned_array<double> a;
    a.resize(size);
    ASSERT_EQ(a.size(), size);
    EXPECT_TRUE(is_aligned(a.data()));
    a.data()[0] = 1;
    a.data()[size - 1] = 2;
    EXPECT_EQ(a.data()[size - 1], 2);
  }
}

TEST(Aligned_array, keeps_memory_and_values_when_the_size_stays)
{
  CGP::internal::Aligned_array<float> a;
  a.resize(100);
  a.data()[99] = 7;
  const float* const before = a.data();
  a.resize(100);
  EXPECT_EQ(a.data(), before);
  EXPECT_EQ(a.data()[99], 7);
}

TEST(Aligned_array, of_no_numbers_is_empty)
{
  CGP::internal::Aligned_array<double> a;
  EXPECT_EQ(a.data(), nullptr);
  a.resize(5);
  a.resize(0);
  EXPECT_EQ(a.size(), 0);
  EXPECT_EQ(a.data(), nullptr);
}

TEST(Aligned_array, that_cannot_be_allocated_throws_and_holds_nothing)
{
  CGP::internal::Aligned_array<double> a;
  a.resize(5);
  EXPECT_THROW(a.resize(std::int64_t(1) << 56), std::bad_alloc);
  EXPECT_EQ(a.size(), 0);
  EXPECT_EQ(a.data(), nullptr);
  a.resize(7);
  EXPECT_EQ(a.size(), 7);
}

}  // namespace cgp_test::aligned_array_tests
