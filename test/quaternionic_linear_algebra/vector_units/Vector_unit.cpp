// Tests include/Quaternionic_linear_algebra/vector_units/Vector_unit.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

#include <Quaternionic_linear_algebra/vector_units/Vector_unit.h>

#include <gtest/gtest.h>

#include <string>

#include "quaternionic_linear_algebra/every_unit.h"

namespace cgp_test::vector_unit_tests {

namespace CGP = Conformal_geometry_processing;
using Unit = CGP::internal::Vector_unit;

TEST(Vector_unit, is_the_widest_of_the_machine)
{
  ASSERT_FALSE(units_here().empty());
  EXPECT_EQ(CGP::vector_unit(), units_here().back());
}

TEST(Vector_unit, is_the_one_that_was_asked_for_if_there_is_one)
{
  const Unit before = CGP::vector_unit();
  for (const Unit unit : {Unit::baseline, Unit::avx2, Unit::avx512}) {
    const Unit last = CGP::vector_unit();
    EXPECT_EQ(CGP::set_vector_unit(unit), CGP::has_vector_unit(unit));
    EXPECT_EQ(CGP::vector_unit(), CGP::has_vector_unit(unit) ? unit : last);
  }
  EXPECT_TRUE(CGP::set_vector_unit(before));
}

TEST(Vector_unit, has_a_name)
{
  EXPECT_EQ(std::string(CGP::to_string(Unit::avx2)), "AVX2");
  EXPECT_EQ(std::string(CGP::to_string(Unit::avx512)), "AVX-512");
  EXPECT_NE(std::string(CGP::to_string(Unit::baseline)), "");
}

}  // namespace cgp_test::vector_unit_tests
