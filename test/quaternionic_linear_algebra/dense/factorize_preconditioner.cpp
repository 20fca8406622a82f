// Tests dense/block_operators.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/dense/block_operators.h>

#include <gtest/gtest.h>

namespace cgp_test::factorize_preconditioner_tests {

namespace CGP = Conformal_geometry_processing;

struct Solver {
  using Scalar = double;
  using FT = double;
  int factorizations = 0;
  CGP::Solver_status factorize(const CGP::Hermitian_sparse_matrix<double>&,
                               const CGP::Vector<double>&)
  {
    ++factorizations;
    return CGP::Solver_status::success;
  }
};

struct Half_rough_solver : Solver {
  int preconditioners = 0;
  CGP::Solver_status factorize_preconditioner(const CGP::Hermitian_sparse_matrix<double>&,
                                              const CGP::Vector<double>&)
  {
    ++preconditioners;
    return CGP::Solver_status::numerical_issue;
  }
};

struct Rough_solver : Half_rough_solver {
  CGP::Solver_status precondition(const CGP::Block<double>&, CGP::Block<double>&) const
  {
    return CGP::Solver_status::success;
  }
};

const CGP::Hermitian_sparse_matrix<double> A;

TEST(Factorize_preconditioner, is_passed_on_to_solvers_that_can)
{
  Rough_solver solver;
  EXPECT_EQ(CGP::factorize_preconditioner(solver, A, {}), CGP::Solver_status::numerical_issue);
  EXPECT_EQ(solver.preconditioners, 1);
  EXPECT_EQ(solver.factorizations, 0);
}

// Such a factor could not be applied: `solve()` wants one of `factorize()`.
TEST(Factorize_preconditioner, is_not_passed_on_to_solvers_without_precondition)
{
  Half_rough_solver solver;
  EXPECT_EQ(CGP::factorize_preconditioner(solver, A, {}), CGP::Solver_status::success);
  EXPECT_EQ(solver.preconditioners, 0);
  EXPECT_EQ(solver.factorizations, 1);
}

TEST(Factorize_preconditioner, is_any_factorization_of_other_solvers)
{
  Solver solver;
  EXPECT_EQ(CGP::factorize_preconditioner(solver, A, {}), CGP::Solver_status::success);
  EXPECT_EQ(solver.factorizations, 1);
}

}  // namespace cgp_test::factorize_preconditioner_tests
