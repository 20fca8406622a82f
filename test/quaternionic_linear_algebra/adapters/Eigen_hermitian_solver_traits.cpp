// Tests adapters/Eigen_hermitian_solver_traits.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/adapters/Eigen_hermitian_solver_traits.h>

#include "quaternionic_linear_algebra/solver_laws.h"
#include "support/Real_form_traits.h"

namespace cgp_test::eigen_hermitian_solver_traits_tests {

using Traits = CGP::Eigen_hermitian_solver_traits;
using Real_traits = Real_form_traits<CGP::internal::Eigen_backend>;
using Solvers =
    testing::Types<Traits::Solver<double>, Traits::Solver<Quaternion<double>>,
                   Real_traits::Solver<double>, Real_traits::Solver<Quaternion<double>>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Eigen, Hermitian_solver, Solvers);

TEST(Eigen_backend, counts_the_factor_of_a_path_without_fill_in)
{
  // 0 - 1 - 2 in this order: every column but the last has one entry below the diagonal.
  const Conformal_geometry_processing::Sparse_pattern path{{0, 2, 4, 5}, {0, 1, 1, 2, 2}};
  Traits::Solver<Conformal_geometry_processing::Quaternion<double>> solver;
  ASSERT_EQ(solver.analyze(path, {0, 1, 2}), Conformal_geometry_processing::Solver_status::success);
  EXPECT_EQ(solver.statistics().factor_entries, 5);
}

}  // namespace cgp_test::eigen_hermitian_solver_traits_tests
