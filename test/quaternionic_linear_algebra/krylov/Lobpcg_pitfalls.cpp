// Tests krylov/Lobpcg.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/krylov/Lobpcg.h>

#include <gtest/gtest.h>

#include "quaternionic_linear_algebra/lobpcg_runs.h"

namespace cgp_test::lobpcg_pitfalls_tests {

// Singular matrices, rounding errors, eigenvalues close together.
namespace CGP = Conformal_geometry_processing;
using Q = CGP::Quaternion<double>;
using Block = CGP::Block<Q>;

TEST(Lobpcg_pitfalls, is_done_at_once_with_the_exact_eigenvector_of_a_singular_matrix)
{
  // As rho = 0 does with lambda = 1: the eigenvalue is 0, the vector constant.
  Eigen::VectorXd values = counting(20);
  values[0] = 0;
  const Spectral_problem problem(values);
  for (const double shift : {1e-2, 1e-6, 1e-12}) {
    const auto r = solve(problem, problem.vectors().leftCols(1), until(1e-8), shift);
    EXPECT_TRUE(r.converged);
    EXPECT_EQ(r.iterations, 0);
    EXPECT_NEAR(r.values[0], 0, 1e-14);
  }
}

TEST(Lobpcg_pitfalls, stays_at_the_eigenpair_past_the_rounding_floor)
{
  for (const double second : {1.001, 1.1, 3.0, 100.0})
    for (const double shift : {1e-3, 1e-9}) {
      Eigen::VectorXd values = 100 * counting(30);
      values[0] = 1;
      values[1] = second;
      const Spectral_problem problem(values);
      const auto r = solve(problem, random_block<Q>(30, 1, 3), until(0, 1, 1000), shift);
      EXPECT_TRUE(r.stagnated);
      EXPECT_FALSE(r.converged);
      EXPECT_NEAR(r.values[0], 1, 1e-11);
      EXPECT_LE(problem.sine(r.vectors), 1e-12 / (second - 1));
    }
}

TEST(Lobpcg_pitfalls, stays_at_a_singular_eigenpair_past_the_rounding_floor)
{
  Eigen::VectorXd values = counting(30);
  values[0] = 0;
  const Spectral_problem problem(values);
  for (const double shift : {1e-3, 1e-9}) {
    const auto r = solve(problem, problem.vectors().leftCols(1), until(0, 1, 1000), shift);
    EXPECT_TRUE(r.stagnated);
    EXPECT_LE(problem.sine(r.vectors), 1e-12);
  }
}

TEST(Lobpcg_pitfalls, finds_a_singular_eigenpair_with_a_nearly_singular_preconditioner)
{
  Eigen::VectorXd values = counting(30);
  values[0] = 0;
  const Spectral_problem problem(values);
  for (const double shift : {1e-10, 1e-12, 1e-14}) {
    const auto r = solve(problem, random_block<Q>(30, 1, 7), until(1e-12), shift);
    EXPECT_LE(problem.sine(r.vectors), 1e-11) << shift;
  }
}

// Such a T makes x^H r, which is rounding only, as large as all else in T r; with an exact inverse
// the first step would be the last one.
TEST(Lobpcg_pitfalls, finds_a_singular_eigenpair_with_an_inexact_nearly_singular_preconditioner)
{
  Eigen::VectorXd values = counting(30);
  values[0] = 0;
  const Spectral_problem problem(values);
  const Eigen::VectorXd factors = random_numbers(30, 9).array().abs() + 0.5;
  for (const double shift : {1e-3, 1e-6, 1e-10, 1e-14}) {
    const auto r = CGP::lobpcg(problem.k(), problem.n(), problem.inverse(shift, factors),
                               random_block<Q>(30, 1, 7), until(1e-12));
    EXPECT_TRUE(r.converged) << shift;
    EXPECT_LE(problem.sine(r.vectors), 1e-12) << shift;
  }
}

TEST(Lobpcg_pitfalls, stops_where_there_is_no_direction_left)
{
  const Spectral_problem problem(Eigen::VectorXd::Ones(1));
  const auto r = solve(problem, random_block<Q>(1, 1, 4), until(-1));
  EXPECT_TRUE(r.stagnated);
  EXPECT_NEAR(r.values[0], 1, 1e-14);
}

TEST(Lobpcg_pitfalls, separates_two_nearly_equal_eigenvalues_with_two_columns)
{
  Eigen::VectorXd values = 2 + counting(30).array();
  values[0] = 1;
  values[1] = 1 + 1e-7;
  const Spectral_problem problem(values);
  const auto one = solve(problem, random_block<Q>(30, 1, 5), until(1e-6));
  EXPECT_TRUE(one.converged);
  EXPECT_LE(problem.sine(one.vectors, 2), 1e-5);
  const auto two = solve(problem, random_block<Q>(30, 2, 5), until(1e-9, 2));
  EXPECT_TRUE(two.converged);
  EXPECT_NEAR(*two.gap, 1e-7, 1e-13);
  EXPECT_LE(problem.sine(two.vectors, 2), 1e-8);
}

TEST(Lobpcg_pitfalls, finds_both_vectors_of_a_double_eigenvalue)
{
  // As for the square of an operator with eigenvalues +-1, +-2, ...
  Eigen::VectorXd values(24);
  for (int i = 0; i < 24; ++i) values[i] = (i / 2 + 1) * (i / 2 + 1);
  const Spectral_problem problem(values);
  const auto one = solve(problem, random_block<Q>(24, 1, 6), until(1e-9));
  EXPECT_TRUE(one.converged);
  EXPECT_LE(problem.sine(one.vectors, 2), 1e-8);
  const auto two = solve(problem, random_block<Q>(24, 2, 6), until(1e-9, 2));
  EXPECT_TRUE(two.converged);
  EXPECT_LE(problem.sine(two.vectors, 2), 1e-8);
  EXPECT_NEAR(*two.gap, 0, 1e-13);
  // A block that ends between two equal eigenvalues.
  const auto three = solve(problem, random_block<Q>(24, 3, 6), until(1e-9, 3));
  EXPECT_TRUE(three.converged);
  EXPECT_LE(problem.sine(three.vectors, 4), 1e-8);
}

TEST(Lobpcg_pitfalls, leaves_an_initial_vector_that_is_nearly_orthogonal_to_the_answer)
{
  const Spectral_problem problem(counting(30));
  Block x0 = Block::Constant(30, 1, Q{});
  for (int i = 0; i < 30; ++i) {
    x0(i, 0) = 1e-6 * problem.vectors()(i, 0);
    for (int j = 1; j < 30; ++j) x0(i, 0) += problem.vectors()(i, j);
  }
  const auto r = solve(problem, x0, until(1e-8));
  EXPECT_TRUE(r.converged);
  EXPECT_NEAR(r.values[0], 1, 1e-12);
}

}  // namespace cgp_test::lobpcg_pitfalls_tests
