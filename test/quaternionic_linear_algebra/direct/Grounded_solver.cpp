// Tests direct/Grounded_solver.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/adapters/Eigen_hermitian_solver_traits.h>
#include <Quaternionic_linear_algebra/direct/Grounded_solver.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Core>

#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "quaternionic_linear_algebra/hermitian_matrices.h"
#include "support/decompositions.h"

namespace cgp_test::grounded_solver_tests {

namespace CGP = Conformal_geometry_processing;

struct Solver : CGP::internal::Grounded_solver {
  explicit Solver(std::shared_ptr<const CGP::Sparse_pattern> pattern)
      : Grounded_solver(std::move(pattern), CGP::Eigen_hermitian_solver_traits())
  {}
};

constexpr int n = 30;

Eigen::MatrixXd balanced_columns(int columns)
{
  Eigen::MatrixXd b = random_block<double>(n, columns, 5);
  b.rowwise() -= b.colwise().mean().eval();
  return b;
}

TEST(Grounded_solver, solves_the_singular_system_with_mean_zero)
{
  const auto L = random_laplacian(random_pattern(n, 1), 2);
  Solver solver(L.shared_pattern());
  solver.factorize(L);
  const Eigen::MatrixXd b = balanced_columns(3), x = solver.solve(b);
  EXPECT_LE((real_form(L) * x - b).norm(), 1e-12);
  EXPECT_LE(x.colwise().mean().norm(), 1e-14);
}

TEST(Grounded_solver, gives_the_least_squares_solution_where_there_is_no_solution)
{
  const auto L = random_laplacian(random_pattern(n, 3), 4);
  Solver solver(L.shared_pattern());
  solver.factorize(L);
  const Eigen::MatrixXd b = random_block<double>(n, 2, 6);
  const Eigen::MatrixXd expected = least_squares(real_form(L), b);
  EXPECT_LE((solver.solve(b) - expected).norm(), 1e-12);
}

TEST(Grounded_solver, follows_new_values)
{
  const Pattern pattern = random_pattern(n, 1);
  Solver solver(pattern);
  const Eigen::MatrixXd b = balanced_columns(1);
  for (const std::uint64_t seed : {7u, 8u}) {
    const auto L = random_laplacian(pattern, seed);
    solver.factorize(L);
    EXPECT_LE((real_form(L) * solver.solve(b) - b).norm(), 1e-12);
  }
}

TEST(Grounded_solver, shares_an_ordering)
{
  const auto L = random_laplacian(random_pattern(n, 1), 2);
  const CGP::internal::Ordering order = random_permutation(n, 9);
  CGP::internal::Solver_ref<double> other =
      CGP::Spin_solvers(CGP::Eigen_hermitian_solver_traits()).solver<double>();
  ASSERT_EQ(other.analyze(L.pattern(), order), CGP::Solver_status::success);
  CGP::internal::Grounded_solver solver(L.shared_pattern(), other);
  EXPECT_EQ(solver.ordering(), order);
  solver.factorize(L);
  EXPECT_GE(solver.statistics().factor_entries, L.pattern().size_of_entries());
  const Eigen::MatrixXd b = balanced_columns(1);
  EXPECT_LE((real_form(L) * solver.solve(b) - b).norm(), 1e-12);
}

TEST(Grounded_solver, does_not_care_about_the_unit_of_the_values)
{
  const Pattern pattern = random_pattern(n, 1);
  const auto L = random_laplacian(pattern, 2);
  for (const double unit : {1e-200, 1e200}) {
    CGP::Hermitian_sparse_matrix<double> scaled(pattern);
    for (int k = 0; k < pattern->size_of_entries(); ++k) scaled.value(k) = unit * L.value(k);
    Solver solver(pattern);
    solver.factorize(scaled);
    const Eigen::MatrixXd b = balanced_columns(1);
    EXPECT_LE((real_form(L) * (solver.solve(b) * unit) - b).norm(), 1e-11);
  }
}

TEST(Grounded_solver, refuses_a_pattern_that_does_not_fit)
{
  EXPECT_THROW(Solver(std::make_shared<CGP::Sparse_pattern>()), CGP::Solver_error);
  const CGP::internal::Solver_ref<double> not_analyzed;
  EXPECT_THROW(CGP::internal::Grounded_solver(random_pattern(n, 1), not_analyzed),
               CGP::Solver_error);
  Solver solver(random_pattern(n, 1));
  EXPECT_THROW(solver.factorize(random_laplacian(random_pattern(n, 2), 3)), CGP::Solver_error);
}

TEST(Grounded_solver, refuses_a_matrix_that_is_not_semidefinite)
{
  auto L = random_laplacian(random_pattern(n, 1), 2);
  L.value(L.pattern().offsets[5]) = -1;
  Solver solver(L.shared_pattern());
  try {
    solver.factorize(L);
    FAIL() << "a negative diagonal entry went unnoticed";
  } catch (const CGP::Solver_error& error) {
    EXPECT_NE(std::string(error.what()).find("factorization"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("not positive definite"), std::string::npos);
  }
  EXPECT_THROW(solver.solve(balanced_columns(1)), CGP::Solver_error);
}

TEST(Grounded_solver, refuses_values_that_are_not_finite)
{
  const auto L = random_laplacian(random_pattern(n, 1), 2);
  Solver solver(L.shared_pattern());
  for (int k = 0; k < L.pattern().size_of_entries(); ++k) {
    auto bad = L;
    bad.value(k) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(solver.factorize(bad), CGP::Solver_error) << k;
  }
}

}  // namespace cgp_test::grounded_solver_tests
