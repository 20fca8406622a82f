// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests adapters/Petsc_matrix.h
// Compiled alone: this program does not start PETSc; it is not given test/support/slepc_main.cpp.
#include <Quaternionic_linear_algebra/adapters/Slepc_eigensolver_traits.h>

#include <gtest/gtest.h>

#include "quaternionic_linear_algebra/hermitian_matrices.h"

namespace cgp_test::petsc_handle_tests {

using CGP::internal::check_petsc;

TEST(Check_petsc, throws_what_fits_the_error)
{
  EXPECT_NO_THROW(check_petsc(0));
  EXPECT_THROW(check_petsc(PETSC_ERR_MEM), std::bad_alloc);
  EXPECT_THROW(check_petsc(PETSC_ERR_ARG_SIZ), CGP::Solver_error);
}

TEST(Check_petsc, says_what_petsc_says)
{
  try {
    check_petsc(PETSC_ERR_ARG_SIZ);
    FAIL();
  } catch (const CGP::Solver_error& error) {
    EXPECT_NE(error.message().find("Nonconforming object sizes"), std::string::npos);
  }
}

TEST(Petsc_handle, of_nothing_does_nothing)
{
  CGP::internal::Petsc_vec a, b;
  b = std::move(a);
  EXPECT_EQ(b.get(), nullptr);
}

TEST(Petsc_hermitian_solver, is_in_the_wrong_state_before_petsc_runs)
{
  CGP::internal::Petsc_hermitian_solver<double> solver;
  EXPECT_EQ(solver.analyze(*random_pattern(20, 1)), CGP::Solver_status::wrong_state);
  EXPECT_TRUE(solver.ordering().empty());
}

TEST(Slepc_eigensolver_traits, refuses_to_work_before_petsc_runs)
{
  const auto A = random_definite<Quaternion<double>>(random_pattern(20, 1), 2);
  const CGP::internal::Petsc_hermitian_solver<Quaternion<double>> unused;
  EXPECT_THROW(CGP::Slepc_eigensolver_traits()(A, CGP::Vector<double>::Ones(20), unused,
                                               random_block<Quaternion<double>>(20, 1, 3)),
               CGP::Solver_error);
}

}  // namespace cgp_test::petsc_handle_tests
