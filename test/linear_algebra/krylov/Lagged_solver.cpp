// Tests include/Conformal_geometry_processing/linear_algebra/krylov/Lagged_solver.h
// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/adapters/Eigen_hermitian_solver_traits.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/Lagged_solver.h>
#include <Conformal_geometry_processing/templates.h>

#include <Eigen/Core>

#include <gtest/gtest.h>

#include <type_traits>

#include "linear_algebra/solver_laws.h"

namespace cgp_test {
namespace {

/// the laws compare with exact solutions
template <class Solver>
struct Exact_lagged_solver : CGP::internal::Lagged_solver<Solver> {
  Exact_lagged_solver() { this->set_tolerance(1e-14); }
};

using Quaternionic = CGP::Supernodal_cholesky<Quaternion<double>>;
using Laws =
    testing::Types<Exact_lagged_solver<CGP::Supernodal_cholesky<double>>,
                   Exact_lagged_solver<CGP::Supernodal_cholesky<std::complex<double>>>,
                   Exact_lagged_solver<Quaternionic>,
                   Exact_lagged_solver<CGP::Eigen_hermitian_solver_traits::Solver<double>>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Lagged, Hermitian_solver, Laws);

static_assert(std::is_same_v<CGP::Lagged_solver_traits<>::Solver<Quaternion<double>>,
                             CGP::internal::Lagged_solver<Quaternionic>>);

constexpr int n = 60;

/// A factorization of a small matrix costs only about three solves. This solver reports the costs
/// of large meshes, so that iterations pay off.
template <class Scalar, class Real = double>
struct Dear_solver : CGP::Supernodal_cholesky<Scalar, Real> {
  CGP::Solver_statistics statistics() const
  {
    CGP::Solver_statistics s = CGP::Supernodal_cholesky<Scalar, Real>::statistics();
    s.flops *= 50;
    return s;
  }
};

template <class Scalar>
class Lagged_solver : public testing::Test {
 protected:
  using Vectors = CGP::Block<Scalar>;
  using Matrix = CGP::Hermitian_sparse_matrix<Scalar>;
  using Solver = CGP::internal::Lagged_solver<Dear_solver<Scalar>>;

  void SetUp() override { ASSERT_EQ(solver.analyze(*pattern), Solver_status::success); }

  /// A with every entry changed by up to `change` of itself
  Matrix nearby(double change, std::uint64_t seed = 5) const
  {
    Matrix B = A;
    Random random(seed);
    for (int k = 0; k < pattern->size_of_entries(); ++k)
      B.value(k) = A.value(k) * (1 + change * random.number());
    return B;
  }

  static double error(const Vectors& x, const Matrix& matrix, const Vectors& b)
  {
    const Eigen::MatrixXd expected = definite_solution(dense(matrix), real_columns(b));
    return (real_columns(x) - expected).norm() / expected.norm();
  }

  Pattern pattern = full_pattern(n);
  Matrix A = random_definite<Scalar>(pattern, 2);
  Eigen::VectorXd no_shift;
  Vectors b = random_block<Scalar>(n, 1, 3), x;
  Solver solver;
};

using Scalars = testing::Types<double, std::complex<double>, Quaternion<double>>;
TYPED_TEST_SUITE(Lagged_solver, Scalars);

TYPED_TEST(Lagged_solver, solves_with_the_present_matrix_and_the_old_factor)
{
  ASSERT_EQ(this->solver.factorize(this->A, this->no_shift), Solver_status::success);
  ASSERT_EQ(this->solver.solve(this->b, this->x), Solver_status::success);
  EXPECT_TRUE(this->solver.is_current());
  EXPECT_EQ(this->solver.iterations(), 0);
  EXPECT_LE(this->error(this->x, this->A, this->b), 1e-13);

  const Eigen::VectorXd shift = random_numbers(n, 6).cwiseAbs();
  const auto B = this->nearby(0.01);
  ASSERT_EQ(this->solver.factorize(B, shift), Solver_status::success);
  EXPECT_FALSE(this->solver.is_current());
  ASSERT_EQ(this->solver.solve(this->b, this->x), Solver_status::success);
  EXPECT_GE(this->solver.iterations(), 2);
  EXPECT_EQ(this->solver.factorizations(), 1);
  EXPECT_LE(this->error(this->x, plus_diagonal(B, shift), this->b), 2e-9);
  EXPECT_GE(this->error(this->x, this->A, this->b), 1e-4);
}

TYPED_TEST(Lagged_solver, keeps_the_factor_while_few_iterations_do)
{
  for (int step = 0; step < 30; ++step) {
    const auto B = this->nearby(1e-4, static_cast<std::uint64_t>(step));
    ASSERT_EQ(this->solver.factorize(B, this->no_shift), Solver_status::success);
    ASSERT_EQ(this->solver.solve(this->b, this->x), Solver_status::success);
    EXPECT_LE(this->solver.iterations(), 3);
    EXPECT_LE(this->error(this->x, B, this->b), 2e-9);
  }
  EXPECT_EQ(this->solver.factorizations(), 1);
}

TYPED_TEST(Lagged_solver, is_as_exact_as_it_is_told)
{
  EXPECT_EQ(this->solver.tolerance(), 1e-9);
  ASSERT_EQ(this->solver.factorize(this->A, this->no_shift), Solver_status::success);
  const auto B = this->nearby(1e-3);
  ASSERT_EQ(this->solver.factorize(B, this->no_shift), Solver_status::success);
  for (const double tolerance : {1e-3, 1e-6, 1e-13}) {
    this->solver.set_tolerance(tolerance);
    ASSERT_EQ(this->solver.solve(this->b, this->x), Solver_status::success);
    EXPECT_LE(this->error(this->x, B, this->b), 2 * tolerance);
  }
  EXPECT_EQ(this->solver.factorizations(), 1);
}

TYPED_TEST(Lagged_solver, factors_within_solve_where_the_matrix_has_changed_too_much)
{
  ASSERT_EQ(this->solver.factorize(this->A, this->no_shift), Solver_status::success);
  ASSERT_EQ(this->solver.solve(this->b, this->x), Solver_status::success);
  // from 1 to 1e6 on the diagonal: no few steps of conjugate gradients solve that
  const Eigen::VectorXd shift =
      Eigen::pow(10, Eigen::ArrayXd::LinSpaced(n, 0, 6)).matrix() * this->A.diagonal(0);
  ASSERT_EQ(this->solver.factorize(this->A, shift), Solver_status::success);
  EXPECT_EQ(this->solver.factorizations(), 1);
  ASSERT_EQ(this->solver.solve(this->b, this->x), Solver_status::success);
  EXPECT_EQ(this->solver.factorizations(), 2);
  EXPECT_TRUE(this->solver.is_current());
  EXPECT_LE(this->error(this->x, plus_diagonal(this->A, shift), this->b), 1e-12);
}

TYPED_TEST(Lagged_solver, factors_at_once_where_the_last_step_was_not_worth_its_factor)
{
  // Steps of growing distance from A. The factorization of A is worth some, and not all of them.
  int step = 0;
  for (; this->solver.factorizations() < 2 && step < 20; ++step) {
    const auto B = this->nearby(0.04 * step);
    ASSERT_EQ(this->solver.factorize(B, this->no_shift), Solver_status::success);
    ASSERT_EQ(this->solver.solve(this->b, this->x), Solver_status::success);
    EXPECT_LE(this->error(this->x, B, this->b), 2e-9);
  }
  EXPECT_EQ(this->solver.factorizations(), 2);
  EXPECT_TRUE(this->solver.is_current());
  EXPECT_EQ(this->solver.iterations(), 0);  // so it was not given up within a solve
  EXPECT_GE(step, 3);
}

TYPED_TEST(Lagged_solver, precondition_is_the_factor_at_hand)
{
  ASSERT_EQ(this->solver.factorize(this->A, this->no_shift), Solver_status::success);
  ASSERT_EQ(this->solver.factorize(this->nearby(0.1), this->no_shift), Solver_status::success);
  ASSERT_EQ(this->solver.precondition(this->b, this->x), Solver_status::success);
  EXPECT_LE(this->error(this->x, this->A, this->b), 1e-12);
}

TYPED_TEST(Lagged_solver, precondition_becomes_new_when_it_has_been_used_too_often)
{
  ASSERT_EQ(this->solver.factorize(this->A, this->no_shift), Solver_status::success);
  const auto B = this->nearby(0.1);
  ASSERT_EQ(this->solver.factorize(B, this->no_shift), Solver_status::success);
  int calls = 0;
  for (; !this->solver.is_current() && calls < 1000; ++calls)
    ASSERT_EQ(this->solver.precondition(this->b, this->x), Solver_status::success);
  EXPECT_GE(calls, 3);
  EXPECT_TRUE(this->solver.is_current());
  EXPECT_EQ(this->solver.factorizations(), 2);
  EXPECT_LE(this->error(this->x, B, this->b), 1e-12);
}

TYPED_TEST(Lagged_solver, finds_an_indefinite_matrix_by_a_factorization)
{
  // indefinite with positive diagonal: detected by its curvature only
  Eigen::VectorXd shift = Eigen::VectorXd::Constant(n, -0.999 * this->A.diagonal(0));
  for (int j = 0; j < n; ++j) shift[j] = -0.999 * this->A.diagonal(j);
  ASSERT_EQ(this->solver.factorize(this->A, this->no_shift), Solver_status::success);
  EXPECT_EQ(this->solver.factorize(this->A, shift), Solver_status::success);
  const auto before = this->x;
  EXPECT_EQ(this->solver.solve(this->b, this->x), Solver_status::not_positive_definite);
  EXPECT_TRUE(this->x == before);
  EXPECT_EQ(this->solver.factorizations(), 2);
  EXPECT_EQ(this->solver.solve(this->b, this->x), Solver_status::wrong_state);
  EXPECT_EQ(this->solver.precondition(this->b, this->x), Solver_status::wrong_state);

  // the old factor does not exist any more
  EXPECT_EQ(this->solver.factorize(this->A, shift), Solver_status::not_positive_definite);
  EXPECT_EQ(this->solver.factorize(this->A, this->no_shift), Solver_status::success);
  ASSERT_EQ(this->solver.solve(this->b, this->x), Solver_status::success);
  EXPECT_LE(this->error(this->x, this->A, this->b), 1e-13);
}

TYPED_TEST(Lagged_solver, sees_at_once_that_a_diagonal_is_not_positive)
{
  ASSERT_EQ(this->solver.factorize(this->A, this->no_shift), Solver_status::success);
  Eigen::VectorXd shift = Eigen::VectorXd::Zero(n);
  shift[3] = -2 * this->A.diagonal(3);
  EXPECT_EQ(this->solver.factorize(this->A, shift), Solver_status::not_positive_definite);
}

TYPED_TEST(Lagged_solver, takes_a_larger_shift_for_a_preconditioner_where_that_given_is_too_small)
{
  using Scalar = TypeParam;
  // zero times a shift that is positive on all rows but one pair, where rounding is imitated
  ASSERT_EQ(this->solver.factorize(this->A, this->no_shift), Solver_status::success);
  auto B = this->A;
  for (int k = 0; k < this->pattern->size_of_entries(); ++k) B.value(k) = Scalar{};
  const int k = this->pattern->find(1, 0);
  B.value(k) = CGP::internal::Scalar_traits<Scalar>::from_real(2);
  const Eigen::VectorXd shift = Eigen::VectorXd::Ones(n);
  ASSERT_EQ(this->solver.factorize(B, shift), Solver_status::success);
  Solver_status status = Solver_status::success;
  for (int i = 0; i < 1000 && this->solver.factorizations() < 3; ++i)
    status = this->solver.precondition(this->b, this->x);
  EXPECT_EQ(status, Solver_status::success);
  EXPECT_EQ(this->solver.factorizations(), 3);
  EXPECT_FALSE(this->solver.is_current());
  EXPECT_LE(this->error(this->x, plus_diagonal(B, 10 * shift), this->b), 1e-13);
}

TYPED_TEST(Lagged_solver, reports_values_that_are_not_finite_when_they_come)
{
  ASSERT_EQ(this->solver.factorize(this->A, this->no_shift), Solver_status::success);
  auto B = this->A;
  B.value(17) = CGP::internal::Scalar_traits<TypeParam>::from_real(std::nan(""));
  EXPECT_EQ(this->solver.factorize(B, this->no_shift), Solver_status::numerical_issue);
  EXPECT_EQ(this->solver.solve(this->b, this->x), Solver_status::wrong_state);
  EXPECT_EQ(this->solver.factorize(this->nearby(1e-3), this->no_shift), Solver_status::success);
  EXPECT_EQ(this->solver.factorizations(), 1);  // the old factor has survived
  EXPECT_EQ(this->solver.solve(this->b, this->x), Solver_status::success);

  this->b(0, 0) = CGP::internal::Scalar_traits<TypeParam>::from_real(HUGE_VAL);
  EXPECT_NE(this->solver.solve(this->b, this->x), Solver_status::success);
}

TYPED_TEST(Lagged_solver, shares_the_analysis_with_others_lagged_or_not)
{
  CGP::internal::Lagged_solver<CGP::Supernodal_cholesky<double>> real;
  ASSERT_EQ(real.analyze_like(*this->pattern, this->solver), Solver_status::success);
  EXPECT_EQ(real.factor().structure(), this->solver.factor().structure());
  CGP::Supernodal_cholesky<float> plain;
  ASSERT_EQ(plain.analyze_like(*this->pattern, this->solver.factor()), Solver_status::success);
  ASSERT_EQ(real.analyze_like(*this->pattern, plain), Solver_status::success);
  EXPECT_EQ(real.factor().structure(), plain.structure());
}

TYPED_TEST(Lagged_solver, tells_the_memory_of_the_values_too)
{
  const CGP::Solver_statistics all = this->solver.statistics();
  const CGP::Solver_statistics factor = this->solver.factor().statistics();
  EXPECT_EQ(all.bytes - factor.bytes,
            static_cast<double>(sizeof(TypeParam)) * this->pattern->size_of_entries());
}

TYPED_TEST(Lagged_solver, gives_the_same_bits_twice)
{
  typename TestFixture::Solver second;
  ASSERT_EQ(second.analyze(*this->pattern), Solver_status::success);
  for (int step = 0; step < 12; ++step) {
    const auto B = this->nearby(0.04 * step);
    CGP::Block<TypeParam> y;
    ASSERT_EQ(this->solver.factorize(B, this->no_shift), Solver_status::success);
    ASSERT_EQ(second.factorize(B, this->no_shift), Solver_status::success);
    ASSERT_EQ(this->solver.solve(this->b, this->x), Solver_status::success);
    ASSERT_EQ(second.solve(this->b, y), Solver_status::success);
    EXPECT_TRUE(this->x == y);
    EXPECT_EQ(this->solver.factorizations(), second.factorizations());
  }
}

TEST(Lagged_float_solver, solves_in_double_precision_with_an_old_factor_in_single)
{
  const Pattern pattern = full_pattern(n);
  const auto A = random_definite<Quaternion<double>>(pattern, 2);
  CGP::internal::Lagged_solver<Dear_solver<Quaternion<double>, float>> solver;
  ASSERT_EQ(solver.analyze(*pattern), Solver_status::success);
  ASSERT_EQ(solver.factorize(A, {}), Solver_status::success);
  ASSERT_EQ(solver.factorize(A, Eigen::VectorXd::Constant(n, 1e-3)), Solver_status::success);
  const auto b = random_block<Quaternion<double>>(n, 2, 3);
  CGP::Block<Quaternion<double>> x;
  ASSERT_EQ(solver.solve(b, x), Solver_status::success);
  const Eigen::MatrixXd D = dense(plus_diagonal(A, Eigen::VectorXd::Constant(n, 1e-3)));
  const Eigen::MatrixXd expected = definite_solution(D, real_columns(b));
  EXPECT_LE((real_columns(x) - expected).norm(), 2e-9 * expected.norm());
  EXPECT_EQ(solver.factorizations(), 1);
}

}  // namespace
}  // namespace cgp_test
