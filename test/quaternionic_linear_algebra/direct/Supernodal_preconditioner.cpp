// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests direct/Supernodal_cholesky.h
#include <Quaternionic_linear_algebra/direct/Supernodal_cholesky.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "quaternionic_linear_algebra/every_unit.h"
#include "quaternionic_linear_algebra/solver_laws.h"
#include "support/decompositions.h"

namespace cgp_test::supernodal_preconditioner_tests {

/// the factor that serves as a preconditioner, as a solver
template <class Scalar>
struct Preconditioner : CGP::Supernodal_cholesky<Scalar> {
  using Base = CGP::Supernodal_cholesky<Scalar>;
  Solver_status factorize(const CGP::Hermitian_sparse_matrix<Scalar>& A,
                          const CGP::Vector<double>& shift)
  {
    return Base::factorize_preconditioner(A, shift);
  }
  Solver_status solve(const CGP::Block<Scalar>& b, CGP::Block<Scalar>& x) const
  {
    return Base::precondition(b, x);
  }
};

}  // namespace cgp_test::supernodal_preconditioner_tests

// Rounded numbers have four digits and a half, and the condition numbers of these matrices cost up
// to two.
template <class Scalar>
inline constexpr double
    cgp_test::error_of_solution<cgp_test::supernodal_preconditioner_tests::Preconditioner<Scalar>> =
        2e-3;

namespace cgp_test::supernodal_preconditioner_tests {

using Solvers = testing::Types<Preconditioner<double>, Preconditioner<std::complex<double>>,
                               Preconditioner<Quaternion<double>>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Preconditioner, Hermitian_solver, Solvers);

template <class Scalar>
class Supernodal_preconditioner : public testing::Test {
 protected:
  using Vectors = CGP::Block<Scalar>;
  using Matrix = CGP::Hermitian_sparse_matrix<Scalar>;

  Eigen::MatrixXd preconditioned(const Vectors& b) const
  {
    Vectors x;
    EXPECT_EQ(solver.precondition(b, x), Solver_status::success);
    return real_columns(x);
  }

  double relative_error(const Matrix& A) const
  {
    const Vectors b = random_block<Scalar>(A.size(), 2, 4);
    const Eigen::MatrixXd expected = definite_solution(real_form(A), real_columns(b));
    return (preconditioned(b) - expected).norm() / expected.norm();
  }

  /// (1 1; 1 1 + 1e-9): the second pivot is lost in single precision
  static Matrix nearly_singular()
  {
    Matrix A(pattern_of_edges(2, {{0, 1}}));
    for (const int k : {0, 1, 2}) A.value(k) = from_real(1);
    A.value(2) = from_real(1 + 1e-9);
    return A;
  }

  static Scalar from_real(double x) { return CGP::internal::Scalar_traits<Scalar>::from_real(x); }

  CGP::Supernodal_cholesky<Scalar> solver;
};
using Scalars = testing::Types<double, std::complex<double>, Quaternion<double>>;
TYPED_TEST_SUITE(Supernodal_preconditioner, Scalars);

TYPED_TEST(Supernodal_preconditioner, is_rounded_to_four_digits)
{
  on_every_unit([&] {
    const Pattern pattern = grid_pattern(15, 15);
    const auto A = random_definite<TypeParam>(pattern, 3);
    ASSERT_EQ(this->solver.analyze(*pattern), Solver_status::success);
    ASSERT_EQ(this->solver.factorize_preconditioner(A, {}), Solver_status::success);
    const double error = this->relative_error(A);
    EXPECT_LT(error, 5e-4);
    EXPECT_GT(error, 1e-7);
  });
}

TYPED_TEST(Supernodal_preconditioner, does_not_pass_for_a_solver)
{
  const Pattern pattern = random_pattern(40, 1);
  const auto A = random_definite<TypeParam>(pattern, 2);
  const auto b = random_block<TypeParam>(40, 1, 3);
  CGP::Block<TypeParam> x;
  ASSERT_EQ(this->solver.analyze(*pattern), Solver_status::success);
  ASSERT_EQ(this->solver.factorize_preconditioner(A, {}), Solver_status::success);
  EXPECT_EQ(this->solver.solve(b, x), Solver_status::wrong_state);
  ASSERT_EQ(this->solver.factorize(A, {}), Solver_status::success);
  EXPECT_EQ(this->solver.solve(b, x), Solver_status::success);
  EXPECT_LT(this->relative_error(A), 1e-12) << "a solver is a preconditioner";
  ASSERT_EQ(this->solver.factorize_preconditioner(A, {}), Solver_status::success);
  EXPECT_EQ(this->solver.solve(b, x), Solver_status::wrong_state);
  this->solver.release();
  EXPECT_EQ(this->solver.precondition(b, x), Solver_status::wrong_state);
}

// Rounding must not know the size of a row: slivers have entries that are larger by powers of ten.
TYPED_TEST(Supernodal_preconditioner, is_the_same_for_rows_and_columns_times_powers_of_two)
{
  const Pattern pattern = grid_pattern(12, 12);
  const auto A = random_definite<TypeParam>(pattern, 3);
  const auto power = [](int i) { return std::ldexp(1., 13 * (i % 7) - 39); };
  auto B = A;
  for (int j = 0; j < pattern->size(); ++j)
    for (int k = pattern->offsets[at(j)]; k < pattern->offsets[at(j) + 1]; ++k)
      B.value(k) *= power(j) * power(pattern->indices[at(k)]);
  const auto b = random_block<TypeParam>(pattern->size(), 1, 4);
  auto c = b;
  for (int i = 0; i < pattern->size(); ++i) c(i, 0) *= power(i);
  CGP::Block<TypeParam> x, y;
  ASSERT_EQ(this->solver.analyze(*pattern), Solver_status::success);
  ASSERT_EQ(this->solver.factorize_preconditioner(A, {}), Solver_status::success);
  ASSERT_EQ(this->solver.precondition(b, x), Solver_status::success);
  ASSERT_EQ(this->solver.factorize_preconditioner(B, {}), Solver_status::success);
  ASSERT_EQ(this->solver.precondition(c, y), Solver_status::success);
  for (int i = 0; i < pattern->size(); ++i) y(i, 0) *= power(i);
  EXPECT_EQ(real_columns(y), real_columns(x));
}

TYPED_TEST(Supernodal_preconditioner, needs_about_half_of_the_memory)
{
  const Pattern pattern = grid_pattern(80, 80);
  const auto A = random_definite<TypeParam>(pattern, 3);
  ASSERT_EQ(this->solver.analyze(*pattern), Solver_status::success);
  ASSERT_EQ(this->solver.factorize(A, {}), Solver_status::success);
  const double full = this->solver.statistics().bytes;
  ASSERT_EQ(this->solver.factorize_preconditioner(A, {}), Solver_status::success);
  EXPECT_LT(this->solver.statistics().bytes, 0.55 * full);
}

TYPED_TEST(Supernodal_preconditioner, improves_a_solution_to_double_precision_by_refinement)
{
  const Pattern pattern = random_pattern(80, 5);
  const auto A = random_definite<TypeParam>(pattern, 6);
  ASSERT_EQ(this->solver.analyze(*pattern), Solver_status::success);
  ASSERT_EQ(this->solver.factorize_preconditioner(A, {}), Solver_status::success);
  const Eigen::MatrixXd D = real_form(A);
  const auto b = random_block<TypeParam>(80, 1, 7);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(D.rows());
  for (int i = 0; i < 7; ++i) {
    const Eigen::VectorXd r = real_columns(b) - D * x;
    CGP::Block<TypeParam> residual(80, 1);
    std::copy(r.data(), r.data() + r.size(), reinterpret_cast<double*>(residual.data()));
    x += this->preconditioned(residual);
  }
  EXPECT_LE((D * x - real_columns(b)).norm(), 1e-13 * x.norm());
}

// A float is between 1e-38 and 1e38.
TYPED_TEST(Supernodal_preconditioner, is_linear_beyond_the_range_of_single_precision)
{
  const auto A = random_definite<TypeParam>(random_pattern(80, 5), 6);
  ASSERT_EQ(this->solver.analyze(A.pattern()), Solver_status::success);
  ASSERT_EQ(this->solver.factorize_preconditioner(A, {}), Solver_status::success);
  const CGP::Block<TypeParam> b = random_block<TypeParam>(80, 3, 7);
  const Eigen::MatrixXd x = this->preconditioned(b);
  for (const int exponent : {-1000, -130, 0, 127, 900}) {
    CGP::Block<TypeParam> c = b;
    for (TypeParam& value : c.col(1)) value *= std::ldexp(1., exponent);
    Eigen::MatrixXd y = this->preconditioned(c);
    const Eigen::Index columns = y.cols() / 3;
    y.middleCols(columns, columns) *= std::ldexp(1., -exponent);
    EXPECT_EQ(y, x) << exponent;
  }
}

TYPED_TEST(Supernodal_preconditioner, is_in_double_precision_where_single_precision_fails)
{
  const auto A = this->nearly_singular();
  ASSERT_EQ(this->solver.analyze(A.pattern()), Solver_status::success);
  ASSERT_EQ(this->solver.factorize_preconditioner(A, {}), Solver_status::success);
  const auto b = random_block<TypeParam>(2, 1, 3);
  const Eigen::MatrixXd x = this->preconditioned(b);
  EXPECT_LT((real_form(A) * x - real_columns(b)).norm(), 1e-15 * x.norm());
}

TYPED_TEST(Supernodal_preconditioner, does_not_depend_on_what_was_factorized_before)
{
  const auto A = this->nearly_singular();
  auto good = A;
  good.value(2) = this->from_real(3);
  ASSERT_EQ(this->solver.analyze(A.pattern()), Solver_status::success);
  const auto b = random_block<TypeParam>(2, 1, 3);
  ASSERT_EQ(this->solver.factorize_preconditioner(good, {}), Solver_status::success);
  const Eigen::MatrixXd x = this->preconditioned(b);
  ASSERT_EQ(this->solver.factorize_preconditioner(A, {}), Solver_status::success);
  ASSERT_EQ(this->solver.factorize_preconditioner(good, {}), Solver_status::success);
  EXPECT_EQ(this->preconditioned(b), x);
}

// (1 1; 1 1 + 2^-24): both this and 1 + 2^-25 are 1 in single precision, their sum is not.
TYPED_TEST(Supernodal_preconditioner, adds_a_shift_before_rounding)
{
  auto A = this->nearly_singular();
  A.value(2) = this->from_real(1 + std::ldexp(1., -24));
  const Eigen::VectorXd shift = std::ldexp(1., -25) * Eigen::VectorXd::Unit(2, 1);
  ASSERT_EQ(this->solver.analyze(A.pattern(), {0, 1}), Solver_status::success);
  ASSERT_EQ(this->solver.factorize_preconditioner(A, shift), Solver_status::success);
  CGP::Block<TypeParam> x;
  EXPECT_EQ(this->solver.solve(random_block<TypeParam>(2, 1, 3), x), Solver_status::wrong_state)
      << "single precision was enough";
}

TYPED_TEST(Supernodal_preconditioner, stays_in_single_precision_after_an_indefinite_matrix)
{
  const auto A = random_definite<TypeParam>(random_pattern(40, 1), 2);
  ASSERT_EQ(this->solver.analyze(A.pattern()), Solver_status::success);
  EXPECT_EQ(this->solver.factorize_preconditioner(A, Eigen::VectorXd::Constant(40, -1e6)),
            Solver_status::not_positive_definite);
  ASSERT_EQ(this->solver.factorize_preconditioner(A, {}), Solver_status::success);
  EXPECT_GT(this->relative_error(A), 1e-9);
}

}  // namespace cgp_test::supernodal_preconditioner_tests
