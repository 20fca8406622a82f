// Tests adapters/Cholmod_hermitian_solver_traits.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/adapters/Cholmod_hermitian_solver_traits.h>

#include "quaternionic_linear_algebra/solver_laws.h"
#include "support/Real_form_traits.h"

namespace cgp_test::cholmod_hermitian_solver_traits_tests {

using Traits = CGP::Cholmod_hermitian_solver_traits;
using Real_traits = Real_form_traits<CGP::internal::Cholmod_backend>;
using Solvers =
    testing::Types<Traits::Solver<double>, Traits::Solver<Quaternion<double>>,
                   Real_traits::Solver<double>, Real_traits::Solver<Quaternion<double>>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Cholmod, Hermitian_solver, Solvers);

using Conformal_geometry_processing::cholmod_status;
using Conformal_geometry_processing::Solver_status;

TEST(Cholmod_status, tells_what_went_wrong)
{
  EXPECT_EQ(cholmod_status(CHOLMOD_OK), Solver_status::success);
  EXPECT_EQ(cholmod_status(CHOLMOD_NOT_POSDEF), Solver_status::not_positive_definite);
  EXPECT_EQ(cholmod_status(CHOLMOD_DSMALL), Solver_status::not_positive_definite);
  EXPECT_EQ(cholmod_status(CHOLMOD_OUT_OF_MEMORY), Solver_status::out_of_memory);
  EXPECT_EQ(cholmod_status(CHOLMOD_TOO_LARGE), Solver_status::out_of_memory);
  EXPECT_EQ(cholmod_status(CHOLMOD_INVALID), Solver_status::numerical_issue);
}

TEST(Cholmod_backend, gives_the_same_solution_as_a_dense_factorization_on_a_large_graph)
{
  // Large enough for supernodes of more than one column.
  using namespace cgp_test;
  const auto A = random_definite<Quaternion<double>>(random_pattern(250, 1), 2);
  Traits::Solver<Quaternion<double>> solver;
  ASSERT_EQ(solver.analyze(A.pattern()), Solver_status::success);
  ASSERT_EQ(solver.factorize(A, {}), Solver_status::success);
  const auto b = random_block<Quaternion<double>>(250, 3, 3);
  CGP::Block<Quaternion<double>> x;
  ASSERT_EQ(solver.solve(b, x), Solver_status::success);
  EXPECT_LE((real_form(A) * real_columns(x) - real_columns(b)).norm(), 1e-11);
}

}  // namespace cgp_test::cholmod_hermitian_solver_traits_tests
