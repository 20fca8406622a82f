// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Spin_transformation.h
#include <Quaternionic_linear_algebra/adapters/Cholmod_hermitian_solver_traits.h>
#include <Quaternionic_linear_algebra/adapters/Eigen_hermitian_solver_traits.h>

#include "spin/boundary_cases.h"
#include "support/with_solvers.h"

namespace cgp_test::spin_transformation_boundary_solvers_cholmod_tests {

template <class Solver_traits>
CGP::Spin_result result(const Boundary_condition& condition)
{
  CGP::Spin_transformation_options options{condition};
  options.dirac.tolerance = 1e-10;
  return CGP::Spin_transformation(uneven_cap(), with_solvers<Solver_traits>(options))
      .transform(rho_of_uneven_cap());
}

template <class Solver_traits>
void expect_agreement()
{
  for (const Boundary_condition& condition : conditions_of_uneven_cap()) {
    const CGP::Spin_result expected = result<CGP::Default_solver_traits>(condition);
    const CGP::Spin_result r = result<Solver_traits>(condition);
    EXPECT_TRUE(r.report.converged);
    EXPECT_LT((r.positions - expected.positions).cwiseAbs().maxCoeff(), 1e-8);
    EXPECT_NEAR(r.report.eigenvalue, expected.report.eigenvalue, 1e-8);
  }
}

TEST(Spin_transformation_with_a_boundary, is_the_same_with_the_solver_of_eigen)
{
  expect_agreement<CGP::Eigen_hermitian_solver_traits>();
}

TEST(Spin_transformation_with_a_boundary, is_the_same_with_cholmod)
{
  expect_agreement<CGP::Cholmod_hermitian_solver_traits>();
}

}  // namespace cgp_test::spin_transformation_boundary_solvers_cholmod_tests
