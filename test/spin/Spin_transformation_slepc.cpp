// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Spin_transformation.h
#include <Quaternionic_linear_algebra/adapters/Slepc_eigensolver_traits.h>

#include "spin/solver_agreement.h"

namespace cgp_test::spin_transformation_slepc_tests {

INSTANTIATE_TYPED_TEST_SUITE_P(Over_mpi, Spin_solver, CGP::Petsc_hermitian_solver_traits);

TEST(Spin_transformation, is_the_same_to_ten_digits_without_any_factor_over_mpi)
{
  CGP::Dirac_options options;
  options.tolerance = 1e-12;
  for (const Mesh_view& mesh : {radially_perturbed(bumpy_sphere(2), 0.01), scan(300)}) {
    const CGP::Spin_result expected = transformed<CGP::Default_solver_traits>(mesh, options);
    const CGP::Spin_result result =
        transformed<CGP::Petsc_hermitian_solver_traits, CGP::Slepc_eigensolver_traits>(mesh,
                                                                                       options);
    EXPECT_TRUE(expected.report.converged);
    EXPECT_TRUE(result.report.converged);
    EXPECT_LT(difference(expected, result), 1e-10);
  }
}

}  // namespace cgp_test::spin_transformation_slepc_tests
