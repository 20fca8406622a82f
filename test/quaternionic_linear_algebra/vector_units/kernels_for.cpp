// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests vector_units/Vector_unit.h vector_units/compiled_kernels.h
#include <Quaternionic_linear_algebra/vector_units/Vector_unit.h>
#include <Quaternionic_linear_algebra/vector_units/compiled_kernels.h>

#include <gtest/gtest.h>

#include "quaternionic_linear_algebra/every_unit.h"

namespace cgp_test::kernels_for_tests {

namespace CGP = Conformal_geometry_processing;

int bytes_of(CGP::internal::Vector_unit unit)
{
  return unit == CGP::internal::Avx512_unit::unit ? 64
         : unit == CGP::internal::Avx2_unit::unit ? 32
                                                  : 16;
}

template <class Real>
class Kernels_for : public testing::Test {};
using Reals = testing::Types<double, float>;
TYPED_TEST_SUITE(Kernels_for, Reals);

TYPED_TEST(Kernels_for, a_unit_fill_its_registers)
{
  for (const CGP::internal::Vector_unit unit : units_here())
    for (const int planes : {1, 2, 4}) {
      const CGP::internal::Front_kernels<TypeParam> kernels =
          CGP::kernels_for<TypeParam>(planes, unit);
      EXPECT_EQ(kernels.unit, unit);
      EXPECT_EQ(kernels.layout.planes, planes);
      EXPECT_EQ(kernels.layout.lanes() * static_cast<int>(sizeof(TypeParam)), bytes_of(unit));
    }
}

TYPED_TEST(Kernels_for, no_unit_in_particular_are_those_of_the_unit_in_use)
{
  on_every_unit([] { EXPECT_EQ(CGP::kernels_for<TypeParam>(4).unit, CGP::vector_unit()); });
}

TYPED_TEST(Kernels_for, the_unit_of_this_file_can_be_compiled_here)
{
  const auto kernels = CGP::unit_kernels<CGP::internal::Target_unit, TypeParam>(2);
  EXPECT_EQ(kernels.unit, CGP::internal::Target_unit::unit);
  alignas(64) TypeParam panel[16] = {4};
  EXPECT_EQ(kernels.factor_panel(panel, 1, 1), -1);
  EXPECT_EQ(panel[0], TypeParam(2));
}

}  // namespace cgp_test::kernels_for_tests
