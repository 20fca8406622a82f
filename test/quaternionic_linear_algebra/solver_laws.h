// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/dense/Solver_status.h>
#include <Quaternionic_linear_algebra/direct/Ordering.h>

#include <Eigen/Core>

#include <gtest/gtest.h>

#include <limits>

#include "quaternionic_linear_algebra/hermitian_matrices.h"
#include "support/decompositions.h"

/// What every model of SparseHermitianSolver does; instantiate over solver types.
namespace cgp_test {

using CGP::Solver_status;

/// The relative error that a model may leave in a solution. Exact models keep this one; the test of
/// an approximate one states its own by a specialisation, and why.
template <class Solver>
inline constexpr double error_of_solution = 1e-11;

template <class Solver_>
class Hermitian_solver : public testing::Test {
 protected:
  using Solver = Solver_;
  using Scalar = typename Solver::Scalar;

  static constexpr int n = 40;

  void expect_solves(const CGP::Hermitian_sparse_matrix<Scalar>& matrix, int columns)
  {
    const auto b = random_block<Scalar>(n, columns, 77);
    CGP::Block<Scalar> x;
    ASSERT_EQ(solver.solve(b, x), Solver_status::success);
    const Eigen::MatrixXd expected = definite_solution(real_form(matrix), real_columns(b));
    EXPECT_LE((real_columns(x) - expected).norm(), error_of_solution<Solver> * expected.norm());
  }

  Pattern pattern = random_pattern(n, 1);
  CGP::Hermitian_sparse_matrix<Scalar> A = random_definite<Scalar>(pattern, 2);
  Eigen::VectorXd no_shift;
  Solver solver;
};

TYPED_TEST_SUITE_P(Hermitian_solver);

TYPED_TEST_P(Hermitian_solver, solves_for_one_or_several_right_hand_sides)
{
  ASSERT_EQ(this->solver.analyze(*this->pattern), Solver_status::success);
  ASSERT_EQ(this->solver.factorize(this->A, this->no_shift), Solver_status::success);
  this->expect_solves(this->A, 1);
  this->expect_solves(this->A, 5);
}

TYPED_TEST_P(Hermitian_solver, succeeds_where_there_is_no_right_hand_side)
{
  using Vectors = CGP::Block<typename TypeParam::Scalar>;
  ASSERT_EQ(this->solver.analyze(*this->pattern), Solver_status::success);
  ASSERT_EQ(this->solver.factorize(this->A, this->no_shift), Solver_status::success);
  Vectors x(3, 2);
  EXPECT_EQ(this->solver.solve(Vectors(this->n, 0), x), Solver_status::success);
  EXPECT_EQ(x.rows(), this->n);
  EXPECT_EQ(x.cols(), 0);
  this->expect_solves(this->A, 2);
}

TYPED_TEST_P(Hermitian_solver, factorizes_again_with_other_values)
{
  ASSERT_EQ(this->solver.analyze(*this->pattern), Solver_status::success);
  for (const std::uint64_t seed : {3u, 4u, 5u}) {
    const auto B = random_definite<typename TypeParam::Scalar>(this->pattern, seed);
    ASSERT_EQ(this->solver.factorize(B, this->no_shift), Solver_status::success);
    this->expect_solves(B, 2);
  }
}

TYPED_TEST_P(Hermitian_solver, adds_a_diagonal_shift)
{
  const Eigen::VectorXd shift = random_numbers(this->n, 6).cwiseAbs();
  ASSERT_EQ(this->solver.analyze(*this->pattern), Solver_status::success);
  ASSERT_EQ(this->solver.factorize(this->A, shift), Solver_status::success);
  this->expect_solves(plus_diagonal(this->A, shift), 1);
}

TYPED_TEST_P(Hermitian_solver, accepts_any_ordering)
{
  const CGP::internal::Ordering order = random_permutation(this->n, 7);
  ASSERT_EQ(this->solver.analyze(*this->pattern, order), Solver_status::success);
  EXPECT_EQ(this->solver.ordering(), order);
  ASSERT_EQ(this->solver.factorize(this->A, this->no_shift), Solver_status::success);
  this->expect_solves(this->A, 2);
}

TYPED_TEST_P(Hermitian_solver, chooses_an_ordering_that_another_solver_can_share)
{
  ASSERT_EQ(this->solver.analyze(*this->pattern), Solver_status::success);
  const CGP::internal::Ordering order = this->solver.ordering();
  EXPECT_EQ(CGP::inverse_permutation(order).size(), static_cast<std::size_t>(this->n));
  TypeParam second;
  ASSERT_EQ(second.analyze(*this->pattern, order), Solver_status::success);
  EXPECT_EQ(second.statistics().factor_entries, this->solver.statistics().factor_entries);
}

TYPED_TEST_P(Hermitian_solver, can_be_analyzed_again_for_another_pattern)
{
  ASSERT_EQ(this->solver.analyze(*random_pattern(17, 8)), Solver_status::success);
  ASSERT_EQ(this->solver.analyze(*this->pattern), Solver_status::success);
  ASSERT_EQ(this->solver.factorize(this->A, this->no_shift), Solver_status::success);
  this->expect_solves(this->A, 1);
}

TYPED_TEST_P(Hermitian_solver, reports_negative_and_zero_pivots_and_recovers)
{
  ASSERT_EQ(this->solver.analyze(*this->pattern), Solver_status::success);
  Eigen::VectorXd shift = Eigen::VectorXd::Zero(this->n);
  shift[this->n / 2] = -2 * this->A.diagonal(this->n / 2);
  EXPECT_EQ(this->solver.factorize(this->A, shift), Solver_status::not_positive_definite);
  EXPECT_EQ(
      this->solver.factorize(
          CGP::Hermitian_sparse_matrix<typename TypeParam::Scalar>(this->pattern), this->no_shift),
      Solver_status::not_positive_definite);
  ASSERT_EQ(this->solver.factorize(this->A, this->no_shift), Solver_status::success);
  this->expect_solves(this->A, 1);
}

TYPED_TEST_P(Hermitian_solver, reports_values_that_are_not_finite)
{
  ASSERT_EQ(this->solver.analyze(*this->pattern), Solver_status::success);
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    for (const int k : {0, 1, this->pattern->size_of_entries() - 1}) {
      auto B = this->A;
      B.value(k) = CGP::internal::Scalar_traits<typename TypeParam::Scalar>::from_real(bad);
      EXPECT_EQ(this->solver.factorize(B, this->no_shift), Solver_status::numerical_issue);
    }
}

TYPED_TEST_P(Hermitian_solver, refuses_calls_in_the_wrong_order)
{
  const auto b = random_block<typename TypeParam::Scalar>(this->n, 1, 9);
  CGP::Block<typename TypeParam::Scalar> x;
  EXPECT_EQ(this->solver.factorize(this->A, this->no_shift), Solver_status::wrong_state);
  EXPECT_EQ(this->solver.solve(b, x), Solver_status::wrong_state);
  ASSERT_EQ(this->solver.analyze(*this->pattern), Solver_status::success);
  EXPECT_EQ(this->solver.solve(b, x), Solver_status::wrong_state);
  const Eigen::VectorXd shift = Eigen::VectorXd::Constant(this->n, -1e6);
  EXPECT_NE(this->solver.factorize(this->A, shift), Solver_status::success);
  EXPECT_EQ(this->solver.solve(b, x), Solver_status::wrong_state);
}

TYPED_TEST_P(Hermitian_solver, refuses_what_has_another_size)
{
  EXPECT_EQ(this->solver.analyze(*this->pattern, {0, 1, 2}), Solver_status::wrong_state);
  EXPECT_EQ(this->solver.analyze(CGP::Sparse_pattern{}), Solver_status::wrong_state);
  ASSERT_EQ(this->solver.analyze(*this->pattern), Solver_status::success);
  const auto other =
      random_definite<typename TypeParam::Scalar>(random_pattern(this->n - 1, 10), 11);
  EXPECT_EQ(this->solver.factorize(other, this->no_shift), Solver_status::wrong_state);
  EXPECT_EQ(this->solver.factorize(this->A, Eigen::VectorXd(3)), Solver_status::wrong_state);
  ASSERT_EQ(this->solver.factorize(this->A, this->no_shift), Solver_status::success);
  CGP::Block<typename TypeParam::Scalar> x;
  EXPECT_EQ(this->solver.solve(random_block<typename TypeParam::Scalar>(3, 1, 12), x),
            Solver_status::wrong_state);
}

TYPED_TEST_P(Hermitian_solver, tells_the_cost)
{
  EXPECT_EQ(this->solver.statistics().factor_entries, 0);
  ASSERT_EQ(this->solver.analyze(*this->pattern), Solver_status::success);
  ASSERT_EQ(this->solver.factorize(this->A, this->no_shift), Solver_status::success);
  const CGP::Solver_statistics s = this->solver.statistics();
  EXPECT_GE(s.factor_entries, this->pattern->size_of_entries());
  EXPECT_LE(s.factor_entries, this->n * (this->n + 1) / 2);
  EXPECT_GE(s.flops, static_cast<double>(s.factor_entries));
  EXPECT_GE(s.bytes, static_cast<double>(s.factor_entries) * sizeof(double));
}

REGISTER_TYPED_TEST_SUITE_P(Hermitian_solver, solves_for_one_or_several_right_hand_sides,
                            succeeds_where_there_is_no_right_hand_side,
                            factorizes_again_with_other_values, adds_a_diagonal_shift,
                            accepts_any_ordering, chooses_an_ordering_that_another_solver_can_share,
                            can_be_analyzed_again_for_another_pattern,
                            reports_negative_and_zero_pivots_and_recovers,
                            reports_values_that_are_not_finite, refuses_calls_in_the_wrong_order,
                            refuses_what_has_another_size, tells_the_cost);

}  // namespace cgp_test
