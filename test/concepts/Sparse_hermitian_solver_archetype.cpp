// Tests doc/Concepts/SparseHermitianSolver.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "concepts/Sparse_hermitian_solver_archetype.h"

#include <Quaternionic_linear_algebra/direct/Grounded_solver.h>
#include <Quaternionic_linear_algebra/krylov/Lobpcg.h>
#include <Quaternionic_linear_algebra/krylov/inverse_power_method.h>

#include <gtest/gtest.h>

#include "concepts/Sparse_hermitian_eigensolver_archetype.h"
#include "quaternionic_linear_algebra/solver_laws.h"

namespace cgp_test::sparse_hermitian_solver_archetype_tests {

using Q = Quaternion<double>;
using Traits = Sparse_hermitian_solver_traits_archetype;
using Solvers = testing::Types<Traits::Solver<double>, Traits::Solver<Q>>;

TEST(Sparse_hermitian_solver_archetype, is_all_that_the_grounded_solver_needs)
{
  const auto L = random_laplacian(random_pattern(20, 1), 2);
  CGP::internal::Grounded_solver solver(L.shared_pattern(), Traits());
  solver.factorize(L);
  Eigen::MatrixXd b = random_block<double>(20, 2, 3);
  b.rowwise() -= b.colwise().mean().eval();
  EXPECT_LE((real_form(L) * solver.solve(b) - b).norm(), 1e-12);
  const CGP::internal::Grounded_solver sharing(L.shared_pattern(), solver.solver());
  EXPECT_EQ(sharing.ordering(), solver.ordering());
}

TEST(Sparse_hermitian_solver_archetype, is_all_that_the_eigenvalue_solvers_need)
{
  const auto A = random_definite<Q>(random_pattern(20, 4), 5);
  const Eigen::VectorXd masses = (random_numbers(20, 6).array() + 2).matrix();
  Traits::Solver<Q> solver;
  ASSERT_EQ(solver.analyze(A.pattern()), CGP::Solver_status::success);
  ASSERT_EQ(solver.factorize(A, {}), CGP::Solver_status::success);
  const auto x0 = random_block<Q>(20, 2, 7);
  CGP::Eigensolver_options options;
  options.max_iterations = 2000;
  options.tolerance = 1e-8;
  const auto lobpcg = CGP::Lobpcg_eigensolver_traits{}(A, masses, solver, x0, options);
  const auto power = CGP::Inverse_power_eigensolver_traits{}(A, masses, solver, x0, options);
  const auto exact = Sparse_hermitian_eigensolver_archetype{}(A, masses, solver, x0, options);
  ASSERT_TRUE(lobpcg.converged && power.converged && exact.converged);
  EXPECT_NEAR(lobpcg.values[0], exact.values[0], 1e-12);
  EXPECT_NEAR(power.values[0], exact.values[0], 1e-12);
}

INSTANTIATE_TYPED_TEST_SUITE_P(Archetype, Hermitian_solver, Solvers);

}  // namespace cgp_test::sparse_hermitian_solver_archetype_tests
