// Tests include/Conformal_geometry_processing/linear_algebra/direct/largest_number.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/direct/largest_number.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "linear_algebra/hermitian_matrices.h"
#include "threads/threads.h"

namespace cgp_test::largest_number_tests {

namespace CGP = Conformal_geometry_processing;
using Q = CGP::Quaternion<double>;
constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                 infinity = std::numeric_limits<double>::infinity();

TEST(Is_finite, sees_every_component_of_every_entry)
{
  auto A = random_hermitian<Q>(random_pattern(12, 1), 2);
  EXPECT_TRUE(CGP::internal::is_finite(A));
  for (int k = 0; k < A.pattern().size_of_entries(); ++k)
    for (double Q::*component : {&Q::w, &Q::x, &Q::y, &Q::z})
      for (const double bad : {nan, infinity, -infinity}) {
        const double good = std::exchange(A.value(k).*component, bad);
        EXPECT_FALSE(CGP::internal::is_finite(A));
        A.value(k).*component = good;
      }
}

TEST(Is_finite, sees_one_number_among_many_on_several_threads)
{
  const Threads setting(2);
  CGP::internal::Aligned_array<float> numbers;
  numbers.resize(100'000);
  std::fill_n(numbers.data(), numbers.size(), -3.f);
  EXPECT_TRUE(CGP::internal::is_finite(numbers));
  for (const std::int64_t i : {0, 8191, 8192, 99'999}) {
    numbers.data()[i] = static_cast<float>(nan);
    EXPECT_FALSE(CGP::internal::is_finite(numbers));
    numbers.data()[i] = 1e30f;
    EXPECT_TRUE(CGP::internal::is_finite(numbers));
  }
}

TEST(Power_of_two, is_just_above_the_largest_number)
{
  CGP::Quaternion_vector<double> v = CGP::Quaternion_vector<double>::Constant(3, {});
  v[0].x = .1;
  for (const double largest : {.75, 1., 1.5, 3e40, 1e-30}) {
    v[1].z = -largest;
    v[0].x = .1 * largest;
    const double power = CGP::internal::power_of_two(v);
    EXPECT_GT(power, largest);
    EXPECT_LE(power, 2 * largest);
    EXPECT_EQ(std::ldexp(1., std::ilogb(power)), power);
  }
}

TEST(Power_of_two, is_one_where_there_is_none)
{
  CGP::Quaternion_vector<double> v = CGP::Quaternion_vector<double>::Constant(3, {});
  EXPECT_EQ(CGP::internal::power_of_two(v), 1);
  for (const double odd : {nan, infinity, 1e-310}) {
    v[1].y = odd;
    EXPECT_EQ(CGP::internal::power_of_two(v), 1);
  }
}

}  // namespace cgp_test::largest_number_tests
