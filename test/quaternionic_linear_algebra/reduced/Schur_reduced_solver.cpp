// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/direct/Ordering.h>
#include <Quaternionic_linear_algebra/reduced/Schur_reduced_solver.h>

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include "quaternionic_linear_algebra/every_unit.h"
#include "quaternionic_linear_algebra/reduced_problem.h"
#include "quaternionic_linear_algebra/reduced_solver_laws.h"
#include "quaternionic_linear_algebra/threads/threads.h"
#include "support/random.h"

#include <cmath>

namespace cgp_test::schur_reduced_solver_tests {

namespace CGP = Conformal_geometry_processing;
using Q = Quaternion<double>;
using Models = testing::Types<CGP::internal::Schur_reduced_solver>;

Eigen::MatrixXd some_definite_matrix(int n)
{
  Eigen::MatrixXd A(n, n);
  for (int j = 0; j < n; ++j) A.col(j) = random_numbers(n, 20 + static_cast<unsigned>(j));
  return A * A.transpose() + Eigen::MatrixXd::Identity(n, n);
}

// Entries above the diagonal must be ignored.
CGP::internal::Dense_cholesky lower_part(const Eigen::MatrixXd& A)
{
  CGP::internal::Dense_cholesky cholesky;
  const int n = static_cast<int>(A.rows());
  cholesky.set_zero(n);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) cholesky(i, j) = i >= j ? A(i, j) : 17 + i;
  return cholesky;
}

TEST(Dense_cholesky, has_the_factor_of_a_matrix)
{
  on_every_unit([&] {
    for (int n : {1, 3, 8, 9, 21, 50}) {
      const Eigen::MatrixXd A = some_definite_matrix(n);
      CGP::internal::Dense_cholesky cholesky = lower_part(A);
      ASSERT_TRUE(cholesky.factorize());
      Eigen::MatrixXd L = Eigen::MatrixXd::Zero(n, n);
      for (int j = 0; j < n; ++j)
        for (int i = j; i < n; ++i) L(i, j) = cholesky(i, j);
      EXPECT_LE((L * L.transpose() - A).norm(), 1e-13 * A.norm()) << n;
    }
  });
}

TEST(Dense_cholesky, solves)
{
  on_every_unit([&] {
    for (int n : {1, 3, 8, 9, 21, 50}) {
      const Eigen::MatrixXd A = some_definite_matrix(n);
      CGP::internal::Dense_cholesky cholesky = lower_part(A);
      ASSERT_TRUE(cholesky.factorize());
      const Eigen::VectorXd b = random_numbers(n, 5);
      Eigen::VectorXd x = b;
      cholesky.solve(x);
      EXPECT_LE((A * x - b).norm(), 1e-11 * b.norm()) << n;
    }
  });
}

TEST(Dense_cholesky, tells_indefinite_matrices)
{
  on_every_unit([&] {
    Eigen::MatrixXd A = some_definite_matrix(20);
    A(19, 19) = -A(19, 19);
    EXPECT_FALSE(lower_part(A).factorize());
    A(19, 19) = std::nan("");
    EXPECT_FALSE(lower_part(A).factorize());
  });
}

TEST(Dense_cholesky, of_no_rows_has_nothing_to_do)
{
  CGP::internal::Dense_cholesky cholesky;
  cholesky.set_zero(0);
  EXPECT_TRUE(cholesky.factorize());
  Eigen::VectorXd none;
  cholesky.solve(none);
  EXPECT_EQ(none.size(), 0);
  EXPECT_EQ(cholesky.bytes(), 0);
}

TEST(Dense_cholesky, gives_its_memory_back)
{
  CGP::internal::Dense_cholesky cholesky = lower_part(some_definite_matrix(8));
  EXPECT_GT(cholesky.bytes(), 0);
  cholesky.release();
  EXPECT_EQ(cholesky.bytes(), 0);
}

/// all rows of the vector reduced, so that nothing is eliminated
Reduced_problem nothing_else()
{
  return reduced_problem(random_pattern(9, 1), {0, 1, 2, 3, 4, 5, 6, 7, 8}, 2);
}

TEST(Reduced_complement, of_nothing_eliminated_is_the_reduced_matrix)
{
  const Reduced_problem p = nothing_else();
  const CGP::internal::Supernodal_structure structure(p.X.pattern(), random_permutation(9, 3), 9);
  CGP::internal::Reduced_complement complement(p.X.pattern(), structure);
  complement.assemble(p.X, p.shift, p.basis());
  ASSERT_TRUE(complement.factorize());
  const CGP::Block<Q> b = random_block<Q>(9, 1, 4);
  CGP::Vector<Q> y(9);
  for (int k = 0; k < 9; ++k) y[k] = b(structure.order()[at(k)]);
  complement.solve(y);
  CGP::Block<Q> x(9, 1);
  for (int k = 0; k < 9; ++k) x(structure.order()[at(k)]) = y[k];
  const Eigen::MatrixXd expected = p.dense_solution(b);
  EXPECT_LE((real_columns(x) - expected).norm(), 1e-13 * expected.norm());
}

TEST(Reduced_complement, knows_whether_it_is_definite)
{
  const Reduced_problem p = nothing_else();
  const CGP::internal::Supernodal_structure structure(p.X.pattern(), random_permutation(9, 5), 9);
  CGP::internal::Reduced_complement complement(p.X.pattern(), structure);
  complement.assemble(p.X, -10 * p.X.diagonal(0) * Eigen::VectorXd::Ones(9), p.basis());
  EXPECT_FALSE(complement.factorize());
  complement.assemble(p.X, {}, p.basis());
  EXPECT_TRUE(complement.factorize());
}

TEST(Reduced_complement, knows_its_size)
{
  const Reduced_problem p = nothing_else();
  const CGP::internal::Supernodal_structure structure(p.X.pattern(), random_permutation(9, 6), 4);
  const CGP::internal::Reduced_complement complement(p.X.pattern(), structure);
  EXPECT_EQ(complement.factor_entries(), 36);
  EXPECT_EQ(complement.bytes(), 64. * sizeof(double));
  EXPECT_NEAR(complement.flops(), 512 / 3., 1e-9);
}

INSTANTIATE_TYPED_TEST_SUITE_P(Schur, Reduced_solver, Models);

TEST(Schur_reduced_solver, gives_the_same_bits_for_any_number_of_threads)
{
  const Reduced_problem p = reduced_problem(disk(30), 1);
  const CGP::internal::Ordering order = CGP::amd_ordering(p.X.pattern());
  const auto b = random_block<Quaternion<double>>(p.X.size(), 1, 2);
  const auto solution = [&](int threads) {
    const Threads setting(threads);
    CGP::internal::Schur_reduced_solver solver;
    CGP::Block<Quaternion<double>> x;
    EXPECT_EQ(solver.analyze(p.X.pattern(), p.rows(), order), Solver_status::success);
    EXPECT_EQ(solver.factorize(p.X, p.shift, p.basis()), Solver_status::success);
    EXPECT_EQ(solver.solve(b, x), Solver_status::success);
    return real_columns(x);
  };
  on_every_unit([&] {
    const Eigen::MatrixXd expected = solution(1);
    for (const int threads : {2, 5}) EXPECT_EQ(solution(threads), expected);
  });
}

TEST(Schur_reduced_solver, solves_on_every_vector_unit)
{
  const Reduced_problem p = reduced_problem(disk(12), 3);
  const auto b = random_block<Quaternion<double>>(p.X.size(), 2, 4);
  const Eigen::MatrixXd expected = p.dense_solution(b);
  on_every_unit([&] {
    CGP::internal::Schur_reduced_solver solver;
    CGP::Block<Quaternion<double>> x;
    ASSERT_EQ(solver.analyze(p.X.pattern(), p.rows(), CGP::amd_ordering(p.X.pattern())),
              Solver_status::success);
    ASSERT_EQ(solver.factorize(p.X, p.shift, p.basis()), Solver_status::success);
    ASSERT_EQ(solver.solve(b, x), Solver_status::success);
    EXPECT_LE((real_columns(x) - expected).norm(), 1e-10 * expected.norm());
  });
}

}  // namespace cgp_test::schur_reduced_solver_tests
