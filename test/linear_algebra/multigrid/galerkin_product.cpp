// Tests include/Conformal_geometry_processing/linear_algebra/multigrid/galerkin_product.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

#include <Conformal_geometry_processing/linear_algebra/multigrid/galerkin_product.h>

#include <gtest/gtest.h>

#include "linear_algebra/multigrid_tools.h"

namespace cgp_test::galerkin_product_tests {

template <class Scalar>
class Galerkin_product : public testing::Test {};
using Scalars = testing::Types<double, Quaternion<double>>;
TYPED_TEST_SUITE(Galerkin_product, Scalars);

CGP::internal::Prolongation prolongation(const Pattern& pattern)
{
  const CGP::internal::Connection_graph g =
      CGP::strong_connections(random_laplacian(pattern, 2), 0);
  return CGP::smoothed_prolongation(g, CGP::aggregate(g), .8);
}

TYPED_TEST(Galerkin_product, is_the_dense_product)
{
  for (const Pattern& pattern : {random_pattern(90, 1), grid_pattern(9, 8), full_pattern(6),
                                 pattern_of_edges(7, {{0, 1}, {3, 5}})}) {
    const auto A = random_hermitian<TypeParam>(pattern, 3);
    const CGP::internal::Prolongation P = prolongation(pattern);
    const auto C = CGP::galerkin_product(A, P);
    const Eigen::MatrixXd D = real_form(P, planes_of<TypeParam>);
    const Eigen::MatrixXd expected = D.transpose() * real_form(A) * D;
    ASSERT_EQ(C.size(), P.coarse_size);
    EXPECT_LT((real_form(C) - expected).cwiseAbs().maxCoeff(), 1e-14 * pattern->size());
  }
}

TYPED_TEST(Galerkin_product, has_a_pattern_in_order_and_a_real_diagonal)
{
  const Pattern pattern = random_pattern(300, 4);
  const auto A = random_hermitian<TypeParam>(pattern, 5);
  const auto C = CGP::galerkin_product(A, prolongation(pattern));
  const CGP::Sparse_pattern& p = C.pattern();
  ASSERT_EQ(p.offsets.front(), 0);
  ASSERT_EQ(p.offsets.back(), p.size_of_entries());
  for (int j = 0; j < C.size(); ++j) {
    const int begin = p.offsets[at(j)], end = p.offsets[at(j) + 1];
    ASSERT_LT(begin, end);
    ASSERT_EQ(p.indices[at(begin)], j);
    for (int k = begin + 1; k < end; ++k) ASSERT_LT(p.indices[at(k - 1)], p.indices[at(k)]);
    EXPECT_EQ(C.value(begin), CGP::internal::Scalar_traits<TypeParam>::from_real(C.diagonal(j)));
  }
}

TYPED_TEST(Galerkin_product, without_coarse_vertices_is_empty)
{
  const Pattern pattern = pattern_of_edges(5, {});
  const auto C =
      CGP::galerkin_product(random_hermitian<TypeParam>(pattern, 6), prolongation(pattern));
  EXPECT_EQ(C.size(), 0);
}

TYPED_TEST(Galerkin_product, gives_the_same_bits_twice)
{
  const Pattern pattern = random_pattern(300, 7);
  const auto A = single(random_hermitian<TypeParam>(pattern, 8));
  const CGP::internal::Prolongation P = prolongation(pattern);
  const auto C = CGP::galerkin_product(A, P), D = CGP::galerkin_product(A, P);
  ASSERT_EQ(C.pattern(), D.pattern());
  for (int k = 0; k < C.pattern().size_of_entries(); ++k) EXPECT_EQ(C.value(k), D.value(k));
}

}  // namespace cgp_test::galerkin_product_tests
