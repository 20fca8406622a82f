// Tests algebra/scalar.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/algebra/scalar.h>

#include <gtest/gtest.h>

#include <complex>

namespace cgp_test::scalar_tests {

namespace CGP = Conformal_geometry_processing;

TEST(Scalar_traits, turn_numbers_into_scalars_and_back)
{
  using Q = CGP::Quaternion<double>;
  EXPECT_EQ(CGP::internal::Scalar_traits<double>::real(3.), 3.);
  EXPECT_EQ(CGP::internal::Scalar_traits<std::complex<double>>::real({3., 4.}), 3.);
  EXPECT_EQ(CGP::internal::Scalar_traits<Q>::real({3, 4, 5, 6}), 3.);
  EXPECT_EQ(CGP::internal::Scalar_traits<double>::from_real(3.), 3.);
  EXPECT_EQ(CGP::internal::Scalar_traits<std::complex<double>>::from_real(3.), 3.);
  EXPECT_EQ(CGP::internal::Scalar_traits<Q>::from_real(3.), (Q{3, 0, 0, 0}));
  EXPECT_EQ(CGP::conjugate(2.), 2.);
  EXPECT_EQ(CGP::conjugate(std::complex<double>(1, 2)), std::complex<double>(1, -2));
}

}  // namespace cgp_test::scalar_tests
