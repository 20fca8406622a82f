// Tests include/Conformal_geometry_processing/linear_algebra/reduced/Real_reduced_solver.h
// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later

#include <Conformal_geometry_processing/linear_algebra/adapters/Eigen_hermitian_solver_traits.h>
#include <Conformal_geometry_processing/linear_algebra/reduced/Real_reduced_solver.h>
#include <Conformal_geometry_processing/templates.h>

#include "linear_algebra/reduced_solver_laws.h"

namespace cgp_test::real_reduced_solver_tests {

using Models = testing::Types<
    CGP::internal::Real_reduced_solver<>,
    CGP::internal::Real_reduced_solver<CGP::Eigen_hermitian_solver_traits::Solver<double>>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Real, Reduced_solver, Models);

}  // namespace cgp_test::real_reduced_solver_tests
