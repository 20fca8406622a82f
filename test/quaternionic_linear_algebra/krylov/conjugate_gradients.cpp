// Tests include/Quaternionic_linear_algebra/krylov/conjugate_gradients.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

#include <Quaternionic_linear_algebra/dense/block_operators.h>
#include <Quaternionic_linear_algebra/krylov/conjugate_gradients.h>

#include <Eigen/Core>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>
#include <vector>

#include "quaternionic_linear_algebra/hermitian_matrices.h"
#include "support/decompositions.h"

namespace cgp_test::conjugate_gradients_tests {

template <class Scalar_>
class Conjugate_gradients : public testing::Test {
 protected:
  using Scalar = Scalar_;
  using Vectors = CGP::Block<Scalar>;
  using Matrix = CGP::Hermitian_sparse_matrix<Scalar>;

  static constexpr int n = 30;
  Pattern pattern = random_pattern(n, 1);
  Matrix A = random_definite<Scalar>(pattern, 2);
  CGP::internal::Conjugate_gradients_options options;
  Vectors x;

  static Vectors none(const Vectors& b) { return b; }

  /// the inverse of a dense matrix, as real columns
  static auto inverse(const Eigen::MatrixXd& D)
  {
    return [D](const Vectors& b) {
      const Eigen::MatrixXd y = definite_solution(D, real_columns(b));
      Vectors z(b.rows(), b.cols());
      std::copy(y.data(), y.data() + y.size(), reinterpret_cast<double*>(z.data()));
      return z;
    };
  }

  /// A with every entry changed by up to `change` of itself
  static Matrix nearby(const Matrix& A, double change)
  {
    Matrix B = A;
    Random random(5);
    for (int k = 0; k < A.pattern().size_of_entries(); ++k)
      B.value(k) = A.value(k) * (1 + change * random.number());
    return B;
  }

  static double energy(const Eigen::MatrixXd& D, const Eigen::VectorXd& e)
  {
    return std::sqrt(e.dot(D * e));
  }
};

using Scalars = testing::Types<double, std::complex<double>, Quaternion<double>>;
TYPED_TEST_SUITE(Conjugate_gradients, Scalars);

TYPED_TEST(Conjugate_gradients, solves_to_the_tolerance_in_the_energy_norm)
{
  const Eigen::MatrixXd D = real_form(this->A);
  const auto b = random_block<TypeParam>(this->n, 3, 3);
  const Eigen::MatrixXd expected = definite_solution(D, real_columns(b));
  for (const double tolerance : {1e-3, 1e-6, 1e-9, 1e-12})
    for (const double change : {0.02, 0.2}) {
      this->options.tolerance = tolerance;
      const auto old = this->inverse(real_form(this->nearby(this->A, change)));
      const auto result =
          CGP::conjugate_gradients(CGP::block_operator(this->A), old, b, this->x, this->options);
      EXPECT_TRUE(result.converged);
      EXPECT_FALSE(result.indefinite);
      EXPECT_LE(result.estimates.maxCoeff(), tolerance);
      const Eigen::MatrixXd error = real_columns(this->x) - expected;
      for (Eigen::Index c = 0; c < 3; ++c)
        EXPECT_LE(this->energy(D, error.col(c)), 2 * tolerance * this->energy(D, expected.col(c)));
    }
}

// A small column has negligible errors after the first step, which is always taken.
TYPED_TEST(Conjugate_gradients, leaves_what_is_negligible)
{
  const Eigen::MatrixXd D = real_form(this->A);
  auto b = random_block<TypeParam>(this->n, 2, 3);
  b.col(1) = (b.col(1) * 1e-3).eval();
  const Eigen::MatrixXd expected = definite_solution(D, real_columns(b));
  const auto old = this->inverse(real_form(this->nearby(this->A, .2)));
  this->options.tolerance = 1e-9;
  this->options.negligible = 1e-4 * std::pow(this->energy(D, expected.col(0)), 2);
  const auto result =
      CGP::conjugate_gradients(CGP::block_operator(this->A), old, b, this->x, this->options);
  EXPECT_TRUE(result.converged);
  const Eigen::MatrixXd error = real_columns(this->x) - expected;
  EXPECT_LE(this->energy(D, error.col(0)), 2e-2 * this->energy(D, expected.col(0)));
  EXPECT_GT(result.estimates[0], 1e-6);
  EXPECT_GT(result.estimates[1], 1e-6);
  EXPECT_GT(real_columns(this->x).col(1).norm(), 0);
}

TYPED_TEST(Conjugate_gradients, multiplies_no_columns_that_are_close)
{
  auto b = random_block<TypeParam>(this->n, 2, 3);
  b.col(1) = (b.col(1) * 1e-3).eval();
  const Eigen::MatrixXd D = real_form(this->A);
  this->options.negligible =
      1e-5 * std::pow(this->energy(D, definite_solution(D, real_columns(b)).col(0)), 2);
  std::vector<Eigen::Index> columns;
  const auto product = [&](const CGP::Block<TypeParam>& y) {
    columns.push_back(y.cols());
    return CGP::block_operator(this->A)(y);
  };
  EXPECT_TRUE(CGP::conjugate_gradients(product, this->none, b, this->x, this->options).converged);
  EXPECT_EQ(columns.front(), 2);
  EXPECT_EQ(columns.back(), 1);
}

TYPED_TEST(Conjugate_gradients, needs_one_step_with_the_inverse_itself)
{
  const auto b = random_block<TypeParam>(this->n, 2, 3);
  const auto result = CGP::conjugate_gradients(CGP::block_operator(this->A),
                                               this->inverse(real_form(this->A)), b, this->x);
  EXPECT_TRUE(result.converged);
  EXPECT_EQ(result.iterations, 1);
}

TYPED_TEST(Conjugate_gradients, ends_after_as_many_steps_as_there_are_eigenvalues)
{
  // Identity plus a matrix of rank one: two eigenvalues, over the quaternions as over the reals.
  const auto v = random_block<TypeParam>(this->n, 1, 4);
  const auto K = [&](CGP::Block<TypeParam> y) {
    for (Eigen::Index c = 0; c < y.cols(); ++c) {
      const TypeParam s = CGP::inner_product(v.col(0), y.col(c));
      for (Eigen::Index i = 0; i < y.rows(); ++i) y(i, c) += v(i, 0) * s;
    }
    return y;
  };
  this->options.tolerance = 1e-12;
  const auto result = CGP::conjugate_gradients(
      K, this->none, random_block<TypeParam>(this->n, 2, 5), this->x, this->options);
  EXPECT_TRUE(result.converged);
  EXPECT_EQ(result.iterations, 2);
}

TYPED_TEST(Conjugate_gradients, treats_every_column_as_if_it_were_alone)
{
  auto b = random_block<TypeParam>(this->n, 3, 3);
  b.col(1) = (b.col(1) * 1e-6).eval();
  this->options.tolerance = 1e-11;
  CGP::conjugate_gradients(CGP::block_operator(this->A), this->none, b, this->x, this->options);
  for (Eigen::Index c = 0; c < 3; ++c) {
    CGP::Block<TypeParam> alone;
    CGP::conjugate_gradients(CGP::block_operator(this->A), this->none,
                             CGP::Block<TypeParam>(b.col(c)), alone, this->options);
    EXPECT_EQ(real_columns(alone), real_columns(this->x).col(c));
  }
}

TYPED_TEST(Conjugate_gradients, knows_the_solution_for_zero)
{
  auto b = random_block<TypeParam>(this->n, 2, 3);
  b.col(0).setConstant(TypeParam{});
  const auto result =
      CGP::conjugate_gradients(CGP::block_operator(this->A), this->none, b, this->x);
  EXPECT_TRUE(result.converged);
  EXPECT_EQ(result.estimates[0], 0);
  EXPECT_EQ(real_columns(this->x).col(0).norm(), 0);
  EXPECT_GT(real_columns(this->x).col(1).norm(), 0);

  const CGP::Block<TypeParam> nothing(this->n, 0);
  EXPECT_TRUE(CGP::conjugate_gradients(CGP::block_operator(this->A), this->none, nothing, this->x)
                  .converged);
  EXPECT_EQ(this->x.cols(), 0);
}

TYPED_TEST(Conjugate_gradients, stops_after_the_allowed_steps_and_says_so)
{
  this->options.tolerance = 1e-14;
  const auto b = random_block<TypeParam>(this->n, 1, 3);
  for (const int most : {0, 1, 3}) {
    this->options.max_iterations = most;
    const auto result = CGP::conjugate_gradients(CGP::block_operator(this->A), this->none, b,
                                                 this->x, this->options);
    EXPECT_FALSE(result.converged);
    EXPECT_FALSE(result.indefinite);
    EXPECT_EQ(result.iterations, most);
  }
}

TYPED_TEST(Conjugate_gradients, tells_a_matrix_or_a_preconditioner_that_is_not_definite)
{
  Eigen::VectorXd shift = Eigen::VectorXd::Zero(this->n);
  shift[7] = -2 * this->A.diagonal(7);
  const auto indefinite = plus_diagonal(this->A, shift);
  const auto b = random_block<TypeParam>(this->n, 1, 3);
  const auto K = CGP::block_operator(this->A), no_K = CGP::block_operator(indefinite);
  EXPECT_TRUE(CGP::conjugate_gradients(no_K, this->none, b, this->x).indefinite);
  EXPECT_TRUE(CGP::conjugate_gradients(K, no_K, b, this->x).indefinite);
  EXPECT_FALSE(CGP::conjugate_gradients(no_K, this->none, b, this->x).converged);
}

TYPED_TEST(Conjugate_gradients, ends_where_a_value_is_not_finite)
{
  auto b = random_block<TypeParam>(this->n, 1, 3);
  b(4, 0) =
      CGP::internal::Scalar_traits<TypeParam>::from_real(std::numeric_limits<double>::quiet_NaN());
  const auto result =
      CGP::conjugate_gradients(CGP::block_operator(this->A), this->none, b, this->x);
  EXPECT_FALSE(result.converged);
  EXPECT_FALSE(result.indefinite);
  EXPECT_EQ(result.iterations, 0);
}

// A low-frequency component that is 1e-5 of the solution, and 1e-11 of the residual: if the
// preconditioner halves it and solves for the rest, the residual norm is not informative.
TEST(Conjugate_gradients_estimate, is_not_fooled_by_short_residuals)
{
  const Eigen::VectorXd k = Eigen::Vector4d(1, 1e12, 1e12, 1e12);
  const Eigen::VectorXd t = Eigen::Vector4d(0.5, 1e-12, 1e-12, 1e-12);
  const auto diagonal = [](const Eigen::VectorXd& d) {
    return [d](const Eigen::MatrixXd& x) { return Eigen::MatrixXd(d.asDiagonal() * x); };
  };
  const Eigen::MatrixXd b = Eigen::Vector4d(1e-11, 1, 1, 1);
  Eigen::MatrixXd x;
  EXPECT_TRUE(CGP::conjugate_gradients(diagonal(k), diagonal(t), b, x).converged);
  EXPECT_NEAR(x(0, 0), b(0, 0) / k[0], 1e-3 * b(0, 0));
}

TEST(Conjugate_gradients_columns, end_with_the_leading_ones)
{
  const Eigen::VectorXd k = Eigen::VectorXd::LinSpaced(50, 1, 50);
  const auto apply = [&](const Eigen::MatrixXd& x) { return Eigen::MatrixXd(k.asDiagonal() * x); };
  const auto none = [](const Eigen::MatrixXd& x) { return x; };
  Eigen::MatrixXd b = Eigen::MatrixXd::Ones(50, 2), x;
  b.col(0).tail(49).setZero();  // found by the first iteration
  CGP::internal::Conjugate_gradients_options options;
  EXPECT_GT(CGP::conjugate_gradients(apply, none, b, x, options).iterations, 10);
  options.leading_columns = 1;
  const auto result = CGP::conjugate_gradients(apply, none, b, x, options);
  EXPECT_EQ(result.iterations, 1);
  EXPECT_TRUE(result.converged);
  EXPECT_NEAR(x(0, 0), 1, 1e-12);
  EXPECT_GT(result.estimates[1], options.tolerance);
}

}  // namespace cgp_test::conjugate_gradients_tests
