// Tests algebra/Quaternion.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

#include <Quaternionic_linear_algebra/algebra/Quaternion.h>

#include <gtest/gtest.h>

#include "quaternionic_linear_algebra/hermitian_matrices.h"

namespace cgp_test::scalar_planes_tests {

template <class Scalar>
class Scalar_planes : public testing::Test {
 protected:
  Random random{4};
  Scalar m_a = random_scalar<Scalar>(random);
};
using Scalars = testing::Types<double, std::complex<double>, Quaternion<double>>;
TYPED_TEST_SUITE(Scalar_planes, Scalars);

TYPED_TEST(Scalar_planes, are_the_components)
{
  using Planes = CGP::internal::Scalar_planes<TypeParam>;
  double parts[Planes::size];
  Planes::get(this->m_a, parts);
  EXPECT_EQ(parts[0], CGP::internal::Scalar_traits<TypeParam>::real(this->m_a));
  EXPECT_TRUE(Planes::put(parts) == this->m_a);
  EXPECT_EQ(sizeof(parts), sizeof(TypeParam));
}

TEST(Scalar_planes, of_floats_are_components_too)
{
  float parts[4];
  CGP::internal::Scalar_planes<float>::get(2.5f, parts);
  EXPECT_EQ(CGP::internal::Scalar_planes<float>::put(parts), 2.5f);
  CGP::internal::Scalar_planes<Quaternion<float>>::get({1, 2, 3, 4}, parts);
  for (int q = 0; q < 4; ++q) EXPECT_EQ(parts[q], float(q + 1));
}

}  // namespace cgp_test::scalar_planes_tests
