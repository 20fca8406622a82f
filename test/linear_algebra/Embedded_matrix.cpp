// Tests linear_algebra/Embedded_matrix.h
// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/Embedded_matrix.h>

#include <gtest/gtest.h>

#include "linear_algebra/hermitian_matrices.h"

namespace CGP = Conformal_geometry_processing;
using namespace cgp_test;
using Q = CGP::Quaternion<double>;

namespace {

template <class Scalar>
class Embedded_matrix : public testing::Test {
 protected:
  using Embedding = CGP::Solver_embedding<Scalar>;

  // Entry by entry from the definition: row k of the result is row order[k] of A.
  static void expect_lower_triangle(const CGP::Embedded_matrix<Scalar>& embedded,
                                    const CGP::Hermitian_sparse_matrix<Scalar>& A,
                                    const CGP::Ordering& order)
  {
    const int w = Embedding::width;
    for (int j = 0; j < A.size(); ++j)
      for (int i = j; i < A.size(); ++i) {
        const auto block = Embedding::block(A.coefficient(order[at(i)], order[at(j)]));
        for (int c = 0; c < w; ++c)
          for (int r = i == j ? c : 0; r < w; ++r)
            EXPECT_EQ(embedded.matrix().coeff(w * i + r, w * j + c), block(r, c));
      }
  }
};

using Scalars = testing::Types<double, Q>;
TYPED_TEST_SUITE(Embedded_matrix, Scalars);

}  // namespace

TYPED_TEST(Embedded_matrix, is_the_lower_triangle_in_factor_order)
{
  const Pattern pattern = random_pattern(15, 1);
  const CGP::Ordering order = random_permutation(15, 2);
  CGP::Embedded_matrix<TypeParam> embedded(*pattern, CGP::inverse_permutation(order));
  for (const std::uint64_t seed : {3u, 4u}) {
    const auto A = random_hermitian<TypeParam>(pattern, seed);
    embedded.set_values(A, {});
    this->expect_lower_triangle(embedded, A, order);
  }
}

TYPED_TEST(Embedded_matrix, adds_the_shift_to_the_diagonal)
{
  const Pattern pattern = random_pattern(15, 5);
  const CGP::Ordering order = random_permutation(15, 6);
  const auto A = random_hermitian<TypeParam>(pattern, 7);
  const Eigen::VectorXd shift = random_numbers(15, 8);
  CGP::Embedded_matrix<TypeParam> embedded(*pattern, CGP::inverse_permutation(order));
  embedded.set_values(A, shift);
  this->expect_lower_triangle(embedded, plus_diagonal(A, shift), order);
}

TYPED_TEST(Embedded_matrix, has_sorted_columns_and_nothing_above_the_diagonal)
{
  const Pattern pattern = random_pattern(15, 9);
  const CGP::Embedded_matrix<TypeParam> embedded(
      *pattern, CGP::inverse_permutation(random_permutation(15, 10)));
  const auto& matrix = embedded.matrix();
  for (int j = 0; j < matrix.cols(); ++j) {
    EXPECT_EQ(matrix.innerIndexPtr()[matrix.outerIndexPtr()[j]], j);
    EXPECT_TRUE(std::is_sorted(matrix.innerIndexPtr() + matrix.outerIndexPtr()[j],
                               matrix.innerIndexPtr() + matrix.outerIndexPtr()[j + 1]));
  }
}
