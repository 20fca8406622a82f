// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Spin_transformation.h
#include <Quaternionic_linear_algebra/adapters/Cholmod_hermitian_solver_traits.h>
#include <Quaternionic_linear_algebra/adapters/Eigen_hermitian_solver_traits.h>
#include <Quaternionic_linear_algebra/krylov/inverse_power_method.h>

#include "spin/solver_agreement.h"
#include "support/Double_solver_traits.h"
#include "support/Real_form_traits.h"

namespace cgp_test::spin_transformation_solvers_cholmod_tests {

using Models = testing::Types<
    Double_solver_traits, Real_form_traits<Supernodal_backend>,
    CGP::Cholmod_hermitian_solver_traits, Real_form_traits<CGP::internal::Cholmod_backend>,
    CGP::Eigen_hermitian_solver_traits, Real_form_traits<CGP::internal::Eigen_backend>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Every_model, Spin_solver, Models);

TEST(Spin_transformation_solvers, is_the_same_with_both_eigenvalue_solvers)
{
  CGP::Dirac_options options;
  options.max_iterations = 1000;
  options.tolerance = 1e-7;
  const CGP::Spin_result a = transformed<CGP::Cholmod_hermitian_solver_traits>(icosphere(3));
  const CGP::Spin_result b =
      transformed<CGP::Cholmod_hermitian_solver_traits, CGP::Inverse_power_eigensolver_traits>(
          icosphere(3), options);
  EXPECT_TRUE(b.report);
  EXPECT_LT(difference(a, b), 1e-6);
}

TEST(Spin_transformation_solvers, gives_the_same_bits_twice_with_cholmod)
{
  const CGP::Spin_result a = transformed<CGP::Cholmod_hermitian_solver_traits>(icosphere(3));
  const CGP::Spin_result b = transformed<CGP::Cholmod_hermitian_solver_traits>(icosphere(3));
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.lambda, b.lambda);
}

}  // namespace cgp_test::spin_transformation_solvers_cholmod_tests
