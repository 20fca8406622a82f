// Tests linear_algebra/adapters/Embedded_hermitian_solver.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/adapters/Embedded_hermitian_solver.h>

#include <gtest/gtest.h>

#include <new>
#include <numeric>
#include <type_traits>

#include "linear_algebra/hermitian_matrices.h"

namespace cgp_test::embedded_hermitian_solver_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Solver_status;

enum class Step { none, ordering, analysis, factorization, solution };

Step fails_at = Step::none, runs_out_of_memory_at = Step::none;

Solver_status perform(Step step)
{
  if (runs_out_of_memory_at == step) throw std::bad_alloc();
  return fails_at == step ? Solver_status::numerical_issue : Solver_status::success;
}

// Fails on demand.
template <class Entry>
struct Failing_backend {
  using Matrix = Eigen::SparseMatrix<Entry, Eigen::ColMajor, int>;

  static Solver_status find_ordering(const CGP::Sparse_pattern& pattern,
                                     CGP::internal::Ordering& order)
  {
    order.resize(at(pattern.size()));
    std::iota(order.begin(), order.end(), 0);
    return perform(Step::ordering);
  }
  Solver_status analyze(const Matrix&) { return perform(Step::analysis); }
  Solver_status factorize(const Matrix&) { return perform(Step::factorization); }
  Solver_status solve(const CGP::Block<Entry>& b, CGP::Block<Entry>& x) const
  {
    x = b;
    return perform(Step::solution);
  }
  CGP::Solver_statistics statistics() const { return {}; }
};

using Solver = CGP::Embedded_hermitian_solver<Quaternion<double>, Failing_backend>;

// The first status that is not success.
Solver_status run(Solver& solver)
{
  const auto A = random_definite<Quaternion<double>>(random_pattern(6, 1), 2);
  const auto b = random_block<Quaternion<double>>(6, 2, 3);
  CGP::Block<Quaternion<double>> x;
  Solver_status status = solver.analyze(A.pattern());
  if (status == Solver_status::success) status = solver.factorize(A, {});
  if (status == Solver_status::success) status = solver.solve(b, x);
  if (status == Solver_status::success) {
    EXPECT_EQ(real_columns(x), real_columns(b));
  }
  return status;
}

TEST(Embedded_hermitian_solver, passes_on_the_failure_of_any_step_and_recovers)
{
  Solver solver;
  for (const Step step : {Step::ordering, Step::analysis, Step::factorization, Step::solution}) {
    fails_at = step;
    EXPECT_EQ(run(solver), Solver_status::numerical_issue);
    fails_at = Step::none;
    EXPECT_EQ(run(solver), Solver_status::success);
  }
}

TEST(Embedded_hermitian_solver, turns_bad_alloc_into_a_status)
{
  Solver solver;
  for (const Step step : {Step::ordering, Step::analysis, Step::factorization, Step::solution}) {
    runs_out_of_memory_at = step;
    EXPECT_EQ(run(solver), Solver_status::out_of_memory);
    runs_out_of_memory_at = Step::none;
    EXPECT_EQ(run(solver), Solver_status::success);
  }
}

TEST(Embedded_hermitian_solver, forgets_the_old_analysis_when_a_new_one_fails)
{
  Solver solver;
  ASSERT_EQ(run(solver), Solver_status::success);
  fails_at = Step::ordering;
  EXPECT_EQ(solver.analyze(*random_pattern(6, 1)), Solver_status::numerical_issue);
  fails_at = Step::none;
  CGP::Block<Quaternion<double>> x;
  EXPECT_EQ(solver.solve(random_block<Quaternion<double>>(6, 1, 3), x), Solver_status::wrong_state);
}

TEST(Embedded_hermitian_solver, leaves_the_solution_alone_when_it_fails)
{
  Solver solver;
  ASSERT_EQ(run(solver), Solver_status::success);
  fails_at = Step::solution;
  CGP::Block<Quaternion<double>> x = random_block<Quaternion<double>>(2, 2, 4);
  const Eigen::MatrixXd before = real_columns(x);
  EXPECT_EQ(solver.solve(random_block<Quaternion<double>>(6, 1, 3), x),
            Solver_status::numerical_issue);
  EXPECT_EQ(real_columns(x), before);
  fails_at = Step::none;
}

TEST(Embedded_hermitian_solver, cannot_be_copied)
{
  EXPECT_FALSE(std::is_copy_constructible_v<Solver>);
  EXPECT_FALSE(std::is_copy_assignable_v<Solver>);
}

}  // namespace cgp_test::embedded_hermitian_solver_tests
