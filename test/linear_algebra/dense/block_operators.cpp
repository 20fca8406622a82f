// Tests linear_algebra/dense/block_operators.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/adapters/Eigen_hermitian_solver_traits.h>
#include <Conformal_geometry_processing/linear_algebra/dense/block_operators.h>
#include <Conformal_geometry_processing/linear_algebra/dense/block_products.h>

#include <gtest/gtest.h>

#include "linear_algebra/hermitian_matrices.h"
#include "threads/threads.h"

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

}  // namespace cgp_test::block_operators_tests
