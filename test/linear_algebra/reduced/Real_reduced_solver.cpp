// Tests include/Conformal_geometry_processing/linear_algebra/reduced/Real_reduced_solver.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

#include <Conformal_geometry_processing/linear_algebra/adapters/Eigen_hermitian_solver_traits.h>
#include <Conformal_geometry_processing/linear_algebra/reduced/Real_reduced_solver.h>

#include "linear_algebra/reduced_solver_laws.h"

namespace cgp_test::real_reduced_solver_tests {

struct Over_eigen : CGP::internal::Real_reduced_solver {
  Over_eigen()
      : Real_reduced_solver(
            CGP::Spin_solvers(CGP::Eigen_hermitian_solver_traits()).solver<double>())
  {}
};

using Models = testing::Types<CGP::internal::Real_reduced_solver, Over_eigen>;
INSTANTIATE_TYPED_TEST_SUITE_P(Real, Reduced_solver, Models);

}  // namespace cgp_test::real_reduced_solver_tests
