// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/adapters/Eigen_hermitian_solver_traits.h>
#include <Quaternionic_linear_algebra/dense/block_operators.h>

#include <gtest/gtest.h>

#include "quaternionic_linear_algebra/hermitian_matrices.h"
#include "quaternionic_linear_algebra/threads/threads.h"

namespace cgp_test::block_operators_tests {

namespace CGP = Conformal_geometry_processing;
using Q = CGP::Quaternion<double>;

TEST(Block_operator, multiplies_all_columns_by_a_matrix)
{
  const auto A = random_hermitian<Q>(random_pattern(12, 1), 2);
  const auto x = random_block<Q>(12, 3, 3);
  const Eigen::MatrixXd y = real_columns(CGP::block_operator(A)(x));
  EXPECT_LE((y - real_form(A) * real_columns(x)).norm(), 1e-13);
}

TEST(Block_operator, multiplies_all_columns_by_masses)
{
  const Eigen::VectorXd m = random_numbers(12, 4);
  const auto x = random_block<Q>(12, 3, 5);
  const Eigen::MatrixXd y = real_columns(CGP::block_operator(m)(x));
  EXPECT_EQ(y, four_times(m).asDiagonal() * real_columns(x));
}

TEST(Block_operator, gives_the_same_bits_for_any_number_of_threads)
{
  const int n = 20'000;  // large enough for several ranges
  const auto A = random_hermitian<Q>(random_pattern(n, 1), 2);
  const Eigen::VectorXd m = random_numbers(n, 4);
  const auto x = random_block<Q>(n, 2, 3);
  const auto all = [&] {
    const CGP::Block<Q> Ax = CGP::block_operator(A)(x), mx = CGP::block_operator(m)(x);
    CGP::Block<Q> sum = Ax;
    CGP::add_combination(sum, mx, CGP::gram_matrix(x, Ax));
    CGP::replace_by_combination(sum, CGP::gram_matrix(x, x), mx, CGP::gram_matrix(x, mx));
    return real_columns(sum);
  };
  const Eigen::MatrixXd one = all();
  const CGP::internal::Thread_team team;
  for (const int threads : {2, 3}) {
    const Threads setting(threads);
    EXPECT_EQ(all(), one);
  }
}

TEST(Block_operator, writes_where_it_is_told)
{
  const auto A = random_hermitian<Q>(random_pattern(12, 1), 2);
  const auto x = random_block<Q>(12, 3, 3);
  auto y = random_block<Q>(12, 3, 4);
  const auto* const memory = y.data();
  CGP::apply_operator(CGP::block_operator(A), x, y);
  EXPECT_EQ(real_columns(y), real_columns(CGP::block_operator(A)(x)));
  EXPECT_EQ(y.data(), memory);
  CGP::apply_operator([](const CGP::Block<Q>& z) { return CGP::Block<Q>(-z); }, x, y);
  EXPECT_EQ(real_columns(y), -real_columns(x));
}

TEST(Inverse_operator, prefers_what_the_solver_offers_as_a_preconditioner)
{
  struct Half {
    using Scalar = Q;
    CGP::Solver_status solve(const CGP::Block<Q>&, CGP::Block<Q>&) const
    {
      return CGP::Solver_status::wrong_state;
    }
    CGP::Solver_status precondition(const CGP::Block<Q>& b, CGP::Block<Q>& x) const
    {
      x = b / 2.;
      return CGP::Solver_status::success;
    }
  };
  const auto b = random_block<Q>(5, 2, 9);
  EXPECT_EQ(real_columns(CGP::inverse_operator(Half{})(b)), real_columns(b) / 2);
}

TEST(Inverse_operator, undoes_the_matrix)
{
  const auto A = random_definite<Q>(random_pattern(12, 6), 7);
  CGP::Eigen_hermitian_solver_traits::Solver<Q> solver;
  ASSERT_EQ(solver.analyze(A.pattern()), CGP::Solver_status::success);
  ASSERT_EQ(solver.factorize(A, {}), CGP::Solver_status::success);
  const auto x = random_block<Q>(12, 2, 8);
  const auto y = CGP::inverse_operator(solver)(CGP::block_operator(A)(x));
  EXPECT_LE((real_columns(y) - real_columns(x)).norm(), 1e-13);
}

TEST(Inverse_operator, refuses_a_solver_without_a_factor)
{
  const CGP::Eigen_hermitian_solver_traits::Solver<Q> solver;
  EXPECT_THROW(CGP::inverse_operator(solver)(random_block<Q>(3, 1, 1)), CGP::Solver_error);
}

TEST(Gram_matrix, is_the_conjugate_transpose_times_the_other)
{
  const auto A = random_block<Q>(9, 2, 1), B = random_block<Q>(9, 3, 2);
  EXPECT_LE((real_form(CGP::gram_matrix(A, B)) - real_form(A).transpose() * real_form(B)).norm(),
            1e-14);
}

TEST(Combination, multiplies_from_the_right)
{
  const auto V = random_block<Q>(9, 3, 3), C = random_block<Q>(3, 2, 4);
  EXPECT_LE((real_form(CGP::combination(V, C)) - real_form(V) * real_form(C)).norm(), 1e-14);
}

TEST(Replace_by_combination, combines_more_rows_than_it_takes_at_a_time)
{
  const int n = 700;
  for (int columns = 0; columns <= 3; ++columns) {
    const auto W = random_block<Q>(n, columns, 5), V = random_block<Q>(n, 2, 6),
               C = random_block<Q>(columns, 2, 7), D = random_block<Q>(2, 2, 8);
    const CGP::Block<Q> expected = CGP::combination(W, C) + CGP::combination(V, D);
    auto result = W;
    CGP::replace_by_combination(result, C, V, D);
    EXPECT_LE((real_columns(result) - real_columns(expected)).norm(), 1e-12);
  }
}

TEST(Scale_column, scales_just_that_one)
{
  const auto V = random_block<Q>(4, 2, 5);
  auto W = V;
  CGP::scale_column(W, 1, 2.0);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(W(i, 0), V(i, 0));
    EXPECT_EQ(W(i, 1), V(i, 1) + V(i, 1));
  }
}

TEST(Reduced_to, keeps_quaternions_or_their_real_part)
{
  const Q q{1, 2, 3, 4};
  EXPECT_EQ(CGP::reduced_to(CGP::internal::Coefficients::quaternions, q), q);
  EXPECT_EQ(CGP::reduced_to(CGP::internal::Coefficients::reals, q), (Q{1, 0, 0, 0}));
}

TEST(Gram_matrix, over_the_reals_holds_the_inner_products_of_the_components)
{
  const auto A = random_block<Q>(9, 2, 1), B = random_block<Q>(9, 3, 2);
  const auto G = CGP::gram_matrix(A, B, CGP::internal::Coefficients::reals);
  const Eigen::MatrixXd expected = real_columns(A).transpose() * real_columns(B);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 3; ++j) {
      EXPECT_NEAR(G(i, j).w, expected(i, j), 1e-14);
      EXPECT_EQ(G(i, j), (Q{G(i, j).w, 0, 0, 0}));
    }
}

TEST(Extend_orthonormal, makes_columns_orthonormal_with_the_same_span)
{
  const int n = 12, k = 4;
  const auto vectors = random_block<Q>(n, k, 1);
  const Eigen::VectorXd weights = Eigen::VectorXd::LinSpaced(n, .5, 3);
  CGP::Block<Q> V;
  for (int j = 0; j < k; ++j)
    ASSERT_TRUE(CGP::extend_orthonormal<double>(V, weights, vectors.col(j)));
  const auto weighted = CGP::block_operator(weights)(V);
  EXPECT_LE(
      (real_form(CGP::gram_matrix(V, weighted)) - Eigen::MatrixXd::Identity(4 * k, 4 * k)).norm(),
      1e-13);
  const auto again = CGP::combination(V, CGP::gram_matrix(weighted, vectors));
  EXPECT_LE((real_columns(again) - real_columns(vectors)).norm(), 1e-12);
}

TEST(Extend_orthonormal, leaves_out_what_is_in_the_span)
{
  const int n = 12;
  const auto vectors = random_block<Q>(n, 2, 1), factors = random_block<Q>(2, 1, 2);
  const Eigen::VectorXd weights = Eigen::VectorXd::Ones(n);
  CGP::Block<Q> V;
  for (int j = 0; j < 2; ++j) CGP::extend_orthonormal<double>(V, weights, vectors.col(j));
  EXPECT_FALSE(
      CGP::extend_orthonormal<double>(V, weights, CGP::combination(vectors, factors).col(0)));
  EXPECT_FALSE(CGP::extend_orthonormal<double>(V, weights, vectors.col(0) * 0.));
  EXPECT_EQ(V.cols(), 2);
}

}  // namespace cgp_test::block_operators_tests
