// Tests include/Conformal_geometry_processing/linear_algebra/multigrid/Rounding_remainder.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

#include <Conformal_geometry_processing/linear_algebra/multigrid/Rounding_remainder.h>

#include <gtest/gtest.h>

#include <limits>

#include "linear_algebra/multigrid_tools.h"

namespace cgp_test::rounding_remainder_tests {

template <class Scalar>
class Rounding_remainder : public testing::Test {
 protected:
  Pattern pattern = random_pattern(50, 1);
  CGP::Hermitian_sparse_matrix<Scalar> A = random_hermitian<Scalar>(pattern, 2);
  CGP::internal::Rounding_remainder<Scalar> remainder;
};
using Scalars = testing::Types<double, Quaternion<double>>;
TYPED_TEST_SUITE(Rounding_remainder, Scalars);

TYPED_TEST(Rounding_remainder, completes_the_rounded_matrix_to_fourteen_digits)
{
  const auto rounded = this->remainder.split(this->A, {});
  const auto x = random_block<TypeParam>(50, 3, 3);
  CGP::Block<TypeParam> y;
  this->remainder.multiply(rounded, x, y);
  const Eigen::MatrixXd expected = real_form(this->A) * real_columns(x);
  EXPECT_LT(relative_difference(real_columns(y), expected), 2e-15);
}

TYPED_TEST(Rounding_remainder, belongs_to_a_matrix_rounded_to_single_precision)
{
  const auto rounded = this->remainder.split(this->A, {});
  EXPECT_EQ(rounded.shared_pattern(), this->A.shared_pattern());
  EXPECT_TRUE(this->remainder.is_finite());
  for (int k = 0; k < this->pattern->size_of_entries(); ++k)
    EXPECT_EQ(rounded.value(k), CGP::internal::to_single(this->A.value(k)));
}

TYPED_TEST(Rounding_remainder, includes_a_shift_of_the_diagonal)
{
  const Eigen::VectorXd shift = random_numbers(50, 4);
  const auto rounded = this->remainder.split(this->A, shift);
  const auto x = random_block<TypeParam>(50, 1, 5);
  CGP::Block<TypeParam> y;
  this->remainder.multiply(rounded, x, y);
  const Eigen::MatrixXd expected = real_form(plus_diagonal(this->A, shift)) * real_columns(x);
  EXPECT_LT(relative_difference(real_columns(y), expected), 2e-15);
}

TYPED_TEST(Rounding_remainder, tells_values_that_are_not_finite_in_single_precision)
{
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity(), 1e39, -1e39}) {
    auto B = this->A;
    B.value(7) = CGP::internal::Scalar_traits<TypeParam>::from_real(bad);
    this->remainder.split(B, {});
    EXPECT_FALSE(this->remainder.is_finite());
  }
  this->remainder.split(this->A, {});
  EXPECT_TRUE(this->remainder.is_finite());
}

TYPED_TEST(Rounding_remainder, takes_as_much_memory_as_the_rounded_matrix)
{
  this->remainder.split(this->A, {});
  EXPECT_EQ(this->remainder.bytes(), 4. * planes_of<TypeParam> * this->pattern->size_of_entries());
  this->remainder.release();
  EXPECT_EQ(this->remainder.bytes(), 0);
}

}  // namespace cgp_test::rounding_remainder_tests
