// Tests linear_algebra/adapters/Embedded_matrix.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/adapters/Embedded_matrix.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Ordering.h>

#include <gtest/gtest.h>

#include "linear_algebra/hermitian_matrices.h"

namespace cgp_test::embedded_matrix_tests {

namespace CGP = Conformal_geometry_processing;
using Q = CGP::Quaternion<double>;

template <class Scalar_, class Embedding_>
struct Case {
  using Scalar = Scalar_;
  using Embedding = Embedding_;
};

template <class Case>
class Embedded_matrix : public testing::Test {
 protected:
  using Scalar = typename Case::Scalar;
  using Embedding = typename Case::Embedding;
  using Matrix = CGP::internal::Embedded_matrix<Scalar, Embedding>;

  // Entry by entry from the definition: row k of the result is row order[k] of A.
  static void expect_lower_triangle(const Matrix& embedded,
                                    const CGP::Hermitian_sparse_matrix<Scalar>& A,
                                    const CGP::internal::Ordering& order)
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

using Cases = testing::Types<Case<double, CGP::internal::Number_embedding<double>>,
                             Case<Q, CGP::internal::Complex_embedding<Q>>,
                             Case<Q, CGP::internal::Real_embedding<Q>>>;
TYPED_TEST_SUITE(Embedded_matrix, Cases);

TYPED_TEST(Embedded_matrix, is_the_lower_triangle_in_factor_order)
{
  const Pattern pattern = random_pattern(15, 1);
  const CGP::internal::Ordering order = random_permutation(15, 2);
  typename TestFixture::Matrix embedded(*pattern, CGP::inverse_permutation(order));
  for (const std::uint64_t seed : {3u, 4u}) {
    const auto A = random_hermitian<typename TestFixture::Scalar>(pattern, seed);
    embedded.set_values(A, {});
    this->expect_lower_triangle(embedded, A, order);
  }
}

TYPED_TEST(Embedded_matrix, adds_the_shift_to_the_diagonal)
{
  const Pattern pattern = random_pattern(15, 5);
  const CGP::internal::Ordering order = random_permutation(15, 6);
  const auto A = random_hermitian<typename TestFixture::Scalar>(pattern, 7);
  const Eigen::VectorXd shift = random_numbers(15, 8);
  typename TestFixture::Matrix embedded(*pattern, CGP::inverse_permutation(order));
  embedded.set_values(A, shift);
  this->expect_lower_triangle(embedded, plus_diagonal(A, shift), order);
}

TYPED_TEST(Embedded_matrix, has_sorted_columns_and_nothing_above_the_diagonal)
{
  const Pattern pattern = random_pattern(15, 9);
  const typename TestFixture::Matrix embedded(*pattern,
                                              CGP::inverse_permutation(random_permutation(15, 10)));
  const auto& matrix = embedded.matrix();
  for (int j = 0; j < matrix.cols(); ++j) {
    EXPECT_EQ(matrix.innerIndexPtr()[matrix.outerIndexPtr()[j]], j);
    EXPECT_TRUE(std::is_sorted(matrix.innerIndexPtr() + matrix.outerIndexPtr()[j],
                               matrix.innerIndexPtr() + matrix.outerIndexPtr()[j + 1]));
  }
}

TEST(Embedded_entries, fit_an_int_or_are_too_many)
{
  EXPECT_EQ(CGP::internal::embedded_entries(5, 7, 1), 5 + 7);
  EXPECT_EQ(CGP::internal::embedded_entries(5, 7, 4), 5 * 10 + 7 * 16);
  EXPECT_EQ(CGP::internal::embedded_entries(1, 134217727, 4), 10 + 2147483632);
  EXPECT_THROW(CGP::internal::embedded_entries(2, 134217727, 4), std::bad_alloc);
}

}  // namespace cgp_test::embedded_matrix_tests
