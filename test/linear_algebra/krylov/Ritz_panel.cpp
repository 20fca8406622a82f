// Tests linear_algebra/krylov/Ritz_panel.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/dense/block_operators.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/Ritz_panel.h>

#include <gtest/gtest.h>

#include "linear_algebra/hermitian_matrices.h"

namespace cgp_test::ritz_panel_tests {

namespace CGP = Conformal_geometry_processing;
using Q = CGP::Quaternion<double>;

constexpr int n = 12;

class Ritz_panel : public testing::Test {
 protected:
  CGP::internal::Ritz_panel panel(const CGP::Block<Q>& v) const
  {
    return CGP::make_panel(CGP::block_operator(K), CGP::block_operator(N), v);
  }

  // Checks the invariant of a panel: v, K v, N v.
  void expect_consistent(const CGP::internal::Ritz_panel& p) const
  {
    EXPECT_LE((real_columns(p.kv) - real_form(K) * real_columns(p.v)).norm(), 1e-11);
    EXPECT_LE((real_columns(p.nv) - real_form(N) * real_columns(p.v)).norm(), 1e-11);
  }

  CGP::Hermitian_sparse_matrix<Q> K = random_hermitian<Q>(random_pattern(n, 1), 2);
  CGP::Hermitian_sparse_matrix<Q> N = random_definite<Q>(random_pattern(n, 3), 4);
};

double distance_to_identity(const CGP::Block<Q>& A)
{
  return (real_form(A) - Eigen::MatrixXd::Identity(4 * A.rows(), 4 * A.cols())).norm();
}

TEST_F(Ritz_panel, holds_what_k_and_n_make_of_the_vectors)
{
  auto p = panel(random_block<Q>(n, 3, 5));
  expect_consistent(p);
  p.v = random_block<Q>(n, 3, 6);
  CGP::apply_operators(CGP::block_operator(K), CGP::block_operator(N), p);
  expect_consistent(p);
}

TEST_F(Ritz_panel, can_be_replaced_by_a_combination_with_another)
{
  const auto q = panel(random_block<Q>(n, 2, 7));
  for (int columns = 0; columns <= 3; ++columns) {  // fewer than before, as many, or more
    auto p = panel(random_block<Q>(n, columns, 8));
    const auto C = random_block<Q>(columns, 2, 9), D = random_block<Q>(2, 2, 10);
    const Eigen::MatrixXd expected =
        real_columns(CGP::combination(p.v, C)) + real_columns(CGP::combination(q.v, D));
    CGP::replace_by_combination(p, C, q, D);
    EXPECT_LE((real_columns(p.v) - expected).norm(), 1e-13);
    expect_consistent(p);
  }
}

TEST_F(Ritz_panel, has_a_residual_orthogonal_to_the_vector)
{
  const auto p = panel(random_block<Q>(n, 1, 8));
  CGP::Block<Q> r;
  p.residual(r);
  EXPECT_LE(std::abs(CGP::inner_product(p.v.col(0), r.col(0)).w), 1e-13);
}

TEST_F(Ritz_panel, becomes_an_orthonormal_basis_of_the_same_span)
{
  const auto p = panel(random_block<Q>(n, 4, 9));
  auto basis = p;
  CGP::orthonormalize(basis);
  ASSERT_EQ(basis.size(), 4);
  expect_consistent(basis);
  EXPECT_LE(distance_to_identity(CGP::gram_matrix(basis.v, basis.nv)), 1e-13);
  const auto inside = CGP::combination(basis.v, CGP::gram_matrix(basis.nv, p.v));
  EXPECT_LE((real_columns(p.v) - real_columns(inside)).norm(), 1e-13);
}

TEST_F(Ritz_panel, loses_directions_that_depend_on_others)
{
  CGP::Block<Q> v = random_block<Q>(n, 5, 10);
  const Q q{0, 1, -2, 0.5};
  for (int i = 0; i < n; ++i) {
    v(i, 1) = v(i, 0) * q;               // over the quaternions the same direction
    v(i, 3) = v(i, 2) + 1e-8 * v(i, 3);  // nearly the same
    v(i, 4) = v(i, 2) + 1e-3 * v(i, 4);  // clearly another
  }
  auto p = panel(v), zero = panel(CGP::Block<Q>(n, 2));
  CGP::orthonormalize(p);
  CGP::orthonormalize(zero);
  EXPECT_EQ(p.size(), 3);
  expect_consistent(p);
  EXPECT_EQ(zero.size(), 0);
}

TEST(Orthonormal_combinations, depend_on_the_vectors_before_only)
{
  const auto V = random_block<Q>(n, 4, 11);
  const auto G = CGP::gram_matrix(V, V), C = CGP::internal::orthonormal_combinations(G);
  ASSERT_EQ(C.cols(), 4);
  EXPECT_LE(distance_to_identity(CGP::gram_matrix(C, CGP::combination(G, C))), 1e-13);
  for (int j = 0; j < 4; ++j)
    for (int i = j + 1; i < 4; ++i) EXPECT_EQ(CGP::norm(C(i, j)), 0);
}

TEST(Orthonormal_combinations, are_the_same_for_vectors_of_other_lengths)
{
  const auto V = random_block<Q>(n, 3, 11);
  auto W = V;
  const double lengths[] = {1e-150, 1, 1e100};
  for (int j = 0; j < 3; ++j) CGP::scale_column(W, j, lengths[j]);
  const auto of = [](const CGP::Block<Q>& v) {
    return CGP::combination(v, CGP::internal::orthonormal_combinations(CGP::gram_matrix(v, v)));
  };
  EXPECT_LE((real_columns(of(V)) - real_columns(of(W))).norm(), 1e-13);
}

TEST_F(Ritz_panel, over_the_reals_keeps_what_differs_by_a_quaternion)
{
  CGP::Block<Q> v = random_block<Q>(n, 3, 10);
  for (int i = 0; i < n; ++i) {
    v(i, 1) = v(i, 0) * Q{0, 1, -2, 0.5};
    v(i, 2) = 3. * v(i, 0) - v(i, 1);
  }
  auto p = CGP::make_panel(CGP::block_operator(K), CGP::block_operator(N), v,
                           CGP::internal::Coefficients::reals);
  CGP::orthonormalize(p);
  ASSERT_EQ(p.size(), 2);
  expect_consistent(p);
  const Eigen::MatrixXd gram = real_columns(p.v).transpose() * real_columns(p.nv);
  EXPECT_LE((gram - Eigen::MatrixXd::Identity(2, 2)).norm(), 1e-13);
  EXPECT_LE(distance_to_identity(p.gram(p.v, p.nv)), 1e-13);
}

}  // namespace cgp_test::ritz_panel_tests
