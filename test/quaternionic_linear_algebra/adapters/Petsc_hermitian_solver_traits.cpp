// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/adapters/Petsc_hermitian_solver_traits.h>

#include <limits>

#include "quaternionic_linear_algebra/solver_laws.h"
#include "support/decompositions.h"

namespace cgp_test {

// The iteration ends at a residual of 1e-13; condition numbers are below 100.
template <class Scalar>
inline constexpr double error_of_solution<CGP::internal::Petsc_hermitian_solver<Scalar>> = 1e-11;

}  // namespace cgp_test

namespace cgp_test::petsc_hermitian_solver_traits_tests {

using Traits = CGP::Petsc_hermitian_solver_traits;

using Solvers = testing::Types<Traits::Solver<double>, Traits::Solver<Quaternion<double>>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Petsc, Hermitian_solver, Solvers);

template <class Solver>
class Petsc_hermitian_solver : public Hermitian_solver<Solver> {};
TYPED_TEST_SUITE(Petsc_hermitian_solver, Solvers);

TYPED_TEST(Petsc_hermitian_solver, has_a_preconditioner_that_is_symmetric_and_positive)
{
  ASSERT_EQ(this->solver.analyze(*this->pattern), Solver_status::success);
  ASSERT_EQ(this->solver.factorize(this->A, this->no_shift), Solver_status::success);
  const auto b = random_block<typename TypeParam::Scalar>(this->n, 4, 9);
  CGP::Block<typename TypeParam::Scalar> x;
  ASSERT_EQ(this->solver.precondition(b, x), Solver_status::success);
  const Eigen::MatrixXd products = real_columns(b).transpose() * real_columns(x);
  EXPECT_LT((products - products.transpose()).norm(), 1e-6 * products.norm());
  EXPECT_GT(symmetric_eigenvalues(products).minCoeff(), 0);
}

TYPED_TEST(Petsc_hermitian_solver, reports_an_iteration_that_breaks_down)
{
  ASSERT_EQ(this->solver.analyze(*this->pattern), Solver_status::success);
  ASSERT_EQ(this->solver.factorize(this->A, this->no_shift), Solver_status::success);
  auto b = random_block<typename TypeParam::Scalar>(this->n, 1, 9);
  CGP::Block<typename TypeParam::Scalar> x;
  b(3, 0) = CGP::internal::Scalar_traits<typename TypeParam::Scalar>::from_real(
      std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(this->solver.solve(b, x), Solver_status::numerical_issue);
}

}  // namespace cgp_test::petsc_hermitian_solver_traits_tests
